/* show_typing.c — keys of the host and the characters they make as keys of the terminal's keyboard. A
 * character comes as an event of its own, right after its key: the key waits for it. */
#include "emu/show.h"

static uint8_t code_of(enum vm_key key)
{
    static const struct {
        enum vm_key key;
        uint8_t code;
    } others[] = {
        {VM_KEY_ENTER, KEYCODE_ENTER},
        {VM_KEY_TAB, KEYCODE_TAB},
        {VM_KEY_BACKSPACE, KEYCODE_BACKSPACE},
        {VM_KEY_ESCAPE, KEYCODE_ESCAPE},
        {VM_KEY_UP, KEYCODE_UP},
        {VM_KEY_DOWN, KEYCODE_DOWN},
        {VM_KEY_LEFT, KEYCODE_LEFT},
        {VM_KEY_RIGHT, KEYCODE_RIGHT},
        {VM_KEY_HOME, KEYCODE_HOME},
        {VM_KEY_END, KEYCODE_END},
        {VM_KEY_INSERT, KEYCODE_INSERT},
        {VM_KEY_DELETE, KEYCODE_DELETE},
        {VM_KEY_PAGE_UP, KEYCODE_PAGE_UP},
        {VM_KEY_PAGE_DOWN, KEYCODE_PAGE_DOWN},
        {VM_KEY_LEFT_SHIFT, KEYCODE_SHIFT},
        {VM_KEY_RIGHT_SHIFT, KEYCODE_SHIFT},
        {VM_KEY_LEFT_CONTROL, KEYCODE_CONTROL},
        {VM_KEY_LEFT_ALT, KEYCODE_ALT},
        {VM_KEY_RIGHT_ALT, KEYCODE_ALT},
        {VM_KEY_CAPS_LOCK, KEYCODE_CAPS_LOCK},
        {VM_KEY_LEFT_SUPER, KEYCODE_SUPER},
        {VM_KEY_RIGHT_SUPER, KEYCODE_SUPER},
        {VM_KEY_MENU, KEYCODE_MENU},
        {VM_KEY_KP_DECIMAL, KEYCODE_PAD_POINT},
        {VM_KEY_KP_DIVIDE, KEYCODE_PAD_DIVIDE},
        {VM_KEY_KP_MULTIPLY, KEYCODE_PAD_TIMES},
        {VM_KEY_KP_SUBTRACT, KEYCODE_PAD_MINUS},
        {VM_KEY_KP_ADD, KEYCODE_PAD_PLUS},
        {VM_KEY_KP_ENTER, KEYCODE_PAD_ENTER},
        {VM_KEY_KP_EQUAL, KEYCODE_PAD_EQUAL},
    };
    if (key >= ' ' && key < 0x7F)
        return (uint8_t)key;
    if (key >= VM_KEY_F1 && key <= VM_KEY_F12)
        return (uint8_t)(KEYCODE_F1 + (key - VM_KEY_F1));
    if (key >= VM_KEY_KP_0 && key <= VM_KEY_KP_9)
        return (uint8_t)(KEYCODE_PAD_0 + (key - VM_KEY_KP_0));
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (others[i].key == key)
            return others[i].code;
    return 0;
}

static void key(struct vm_show *show, uint8_t code, uint8_t character, bool pressed)
{
    if (code)
        show->held[code] = pressed;
    vm_show_do(show, (struct inp_act){.device = INP_KEYBOARD,
                                      .verb = pressed ? INP_PRESS : INP_RELEASE,
                                      .code = code,
                                      .character = character});
}

/* A key whose character has not come makes none. */
static void press_waiting(struct vm_show *show, uint8_t character)
{
    if (!show->key_waits)
        return;
    show->key_waits = false;
    key(show, show->waiting_code, character, true);
}

/* Ctrl with a letter makes a control character, whatever the layout. */
static uint8_t control_character(const struct vm_event *event)
{
    enum vm_key k = event->u.key.key;
    return (event->u.key.modifiers & VM_MOD_CONTROL) && k >= '@' && k <= '_' ? k & 0x1F : 0;
}

void vm_show_key_event(struct vm_show *show, const struct vm_event *event)
{
    uint8_t code = code_of(event->u.key.key);
    if (event->u.key.action == VM_REPEAT || (!code && event->u.key.action != VM_PRESS))
        return; /* the keyboard repeats by itself */
    if (event->u.key.action == VM_RELEASE) {
        if (show->held[code])
            key(show, code, 0, false);
        return;
    }
    uint8_t control = control_character(event);
    if (control || code >= 0x80) {
        key(show, code, control, true);
        return;
    }
    show->key_waits = true;
    show->waiting_code = code;
}

void vm_show_text_event(struct vm_show *show, uint32_t character)
{
    if (character >= 0x80) {
        vm_show_say(show, "the keyboard is ASCII");
        press_waiting(show, 0);
    } else if (show->key_waits) {
        press_waiting(show, (uint8_t)character);
    } else {
        key(show, 0, (uint8_t)character, true);
    }
}

void vm_show_release_keys(struct vm_show *show)
{
    for (int code = 1; code < 256; code++)
        if (show->held[code])
            key(show, (uint8_t)code, 0, false);
}

void vm_show_key_settle(struct vm_show *show)
{
    press_waiting(show, 0);
}
