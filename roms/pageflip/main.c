/* pageflip — why a moving picture needs two pages: torn when drawn under the beam, whole when
 * flipped at retrace.
 *
 *      kinescope run roms/pageflip.elf [--console]
 *
 * Two seconds each by turns. Without sync there is one page. The program draws on it 73 times a
 * second, wherever the beam is. It is faster than the beam: rows above the one where it overtakes
 * the beam have just been shown as they were, those below are shown as they are now. A red mark hangs
 * from that row; the bars are broken there, and the solid is seen half drawn. With sync there are two
 * pages: what is drawn on the one that is not shown is shown from the next retrace on, and nothing is
 * ever broken.
 *
 * Keys: t changes over, and then it stays; q ends the program.
 * Marks: n when the n-th turn's first picture is drawn; odd ones are without sync.
 */
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/bsp/video.h"
#include "roms/pageflip/pageflip.h"

#define TURN      (2 * TIMER_HZ)
#define UNSYNCED  73   /* pictures a second */
#define SPEED     700  /* of the bars, pixels a second */
#define TURN_RATE 0.9f /* of the solid, radians a second */

struct show {
    struct pageflip_page page[2];
    bool synced, stays;
    unsigned shown; /* which page is */
    uint64_t began; /* this turn */
    uint64_t next;  /* picture without sync */
    uint32_t turns;
};

static void draw(struct pageflip_page *page, bool look)
{
    uint64_t now = timer_now();
    pageflip_bars(page, (int)(now * SPEED / TIMER_HZ), look);
    pageflip_solid(page, TURN_RATE * (float)(now / 100) / (float)(TIMER_HZ / 100));
}

/* One picture: where the beam is does not matter. */
static void unsynced(struct show *show)
{
    struct pageflip_page *page = &show->page[show->shown];
    uint64_t now = timer_now();
    if (now < show->next)
        timer_sleep(show->next - now);
    show->next = timer_now() + TIMER_HZ / UNSYNCED;
    draw(page, true);
}

static void synced(struct show *show)
{
    show->shown = 1 - show->shown;
    draw(&show->page[show->shown], false);
    video_show(&show->page[show->shown].canvas);
    video_wait_retrace();
}

static void turn(struct show *show, bool to_synced)
{
    show->synced = to_synced;
    show->began = timer_now();
    for (int i = 0; i < 2; i++) {
        pageflip_text(&show->page[i], to_synced);
        pageflip_unmark(&show->page[i]);
    }
    draw(&show->page[show->shown], false);
    board_mark(++show->turns);
}

static bool keys(struct show *show)
{
    int c = console_poll();
    if (c == 't') {
        show->stays = true;
        turn(show, !show->synced);
    }
    return c != 'q';
}

int main(void)
{
    static struct show show;
    if (!video_present()) {
        console_write("pageflip: this board has no raster head.\n");
        return 1;
    }
    struct canvas canvas = video_open(8);
    pageflip_colours();
    for (unsigned i = 0; i < 2; i++)
        pageflip_stage(&show.page[i], video_page(&canvas, i));
    turn(&show, false);
    video_on();
    while (keys(&show)) {
        if (show.synced)
            synced(&show);
        else
            unsynced(&show);
        if (!show.stays && timer_now() - show.began >= TURN)
            turn(&show, !show.synced);
    }
    return 0;
}
