/* Every statement of the language against words encoded by hand in octal, in both dialects. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "display_file/program.h"
#include "tests/support/source.h"

static void modes(void **state)
{
    (void)state;
    assert_words("char\nshortv\nlongv\npoint\ngraphx\ngraphy\nrelpoint\n", 0100000, 0104000,
                 0110000, 0114000, 0120000, 0124000, 0130000);
}

static void mode_options(void **state)
{
    (void)state;
    assert_words("char i=0\nchar i=1\nchar i=4\nchar i=7", 0102000, 0102200, 0103000, 0103600);
    assert_words("longv pen=off\nlongv pen=on", 0110100, 0110140);
    assert_words("longv blink=off\nlongv blink=on", 0110020, 0110030);
    assert_words("longv line=solid\nlongv line=dash\nlongv line=longdash\nlongv line=shortdash\n"
                 "longv line=dotdash",
                 0110004, 0110005, 0110005, 0110006, 0110007);
    assert_words("point i=7 pen=on blink=on line=dotdash", 0117777);
    assert_words("point line=3, blink = 1, pen=5-4, i=3+4 ; all of it", 0117777);
    assert_words("POINT I=5 PEN=OFF BLINK=OFF LINE=SOLID", 0117324);
}

static void point_data(void **state)
{
    (void)state;
    assert_words("point\nat 0, 0\nplot 1023, 1023\nat 512, 1\nplot 0, 767", 0114000, 0, 0, 041777,
                 01777, 01000, 1, 040000, 01377);
    assert_words("point\nplot 1,2, 3,4", 0114000, 040001, 2, 040003, 4);
}

static void long_data(void **state)
{
    (void)state;
    assert_words("longv\ndraw 1023, -1023\nmove -1, 0\ndraw 0, 100", 0110000, 041777, 021777,
                 020001, 0, 040000, 0144);
}

static void short_data(void **state)
{
    (void)state;
    assert_words("shortv\ndraw 63, 63\ndraw -63, -63\nmove 1, -1\nmove -1, 1\nmove 0, 0", 0104000,
                 057677, 077777, 0301, 020201, 0);
    assert_words("relpoint\ndraw 2, 3\nmove 2, 3\ndraw -2, -3", 0130000, 040403, 0403, 060503);
}

static void graphplot_data(void **state)
{
    (void)state;
    assert_words("graphx\nvalue 0, 1023\ngraphy\nvalue 5\nstep 0\nstep 63", 0120000, 0, 01777,
                 0124000, 5, 0174100, 0174177);
}

static void colours(void **state)
{
    (void)state;
    assert_words("colour green\ncolour yellow\ncolour orange\ncolour red", 0175000, 0175200,
                 0175400, 0175600);
    assert_words("colour red step=63\ncolour green, step=0\nCOLOUR 1 + 1", 0175777, 0175100,
                 0175400);
    assert_words(".macro paint c\ncolour c\n.endm\npaint orange\npaint red", 0175400, 0175600);
    assert_words(".dialect dec\nSTATSB!GREEN\nSTATSB!YELLOW\nSTATSB!ORANGE!INCR!5\nSTATSB!RED",
                 0175000, 0175200, 0175505, 0175600);
}

static void text_data(void **state)
{
    (void)state;
    assert_words("char\ntext \"ABCD\"", 0100000, 'B' << 8 | 'A', 'D' << 8 | 'C');
    assert_words("char\ntext \"ABC\"", 0100000, 041101, 0103);
    assert_words("char\ntext \"A\", 'B', 67, \"D\\r\\n\", nul", 0100000, 041101, 042103, 05015, 0);
    assert_words("char\ntext so, 0, 31, si", 0100000, 0000016, 07437);
    assert_words("char\ntext \"\\\"\\\\\\'\\t\\b\\0\\x7e\"", 0100000, 056042, 04447, 00010, 0176);
    assert_words("char\ntext \"a;b\" ; not in the string", 0100000, 035541, 0142);
}

static void status(void **state)
{
    (void)state;
    assert_words("status\nstop\nsync\nstop sync\nsync stop\nstatus stop sync", 0170000, 0172000,
                 0170004, 0172004, 0172004, 0172004);
    assert_words("status stopint=off\nstatus stopint=on\nstop stopint=on", 0171000, 0171400,
                 0173400);
    assert_words("status penlight=on\nstatus penlight=off", 0170200, 0170300);
    assert_words("status italics=off\nstatus italics=on", 0170040, 0170060);
    assert_words("stop sync stopint=on penlight=off italics=on", 0173764);
}

static void jumps(void **state)
{
    (void)state;
    assert_words("a: nop\njump b\njump a\nb: stop", 0164000, 0160000, 012, 0160000, 0, 0172000);
    assert_words("jump 0o177776", 0160000, 0177776);
    assert_words(".org 0o1000\njump .\n.word ., . + 2", 0160000, 01000, 01004, 01006);
}

static void raw_words(void **state)
{
    (void)state;
    assert_words(".word 0o173400, -1, -32768, 65535, 0xBEEF, 0b101, 'A'", 0173400, 0177777, 0100000,
                 0177777, 0137357, 5, 0101);
    assert_words(".word 2.5, -2.5, 2.4999, 7/2, -7/2, 0.5, 1/3", 3, (uint16_t)-3, 2, 4,
                 (uint16_t)-4, 1, 0);
}

static void absolute_drawing(void **state)
{
    (void)state;
    assert_words("point\nat 100, 200\nlongv\nlineto 150, 180\nmoveto 0, 0\nlineto 0, 0", 0114000,
                 0144, 0310, 0110000, 040062, 020024, 020226, 020264);
    /* Through relative drawing and mode changes. */
    assert_words("point\nplot 10, 10\nshortv\ndraw 5, -5\nmove 1, 1\nlongv\nlineto 10, 10", 0114000,
                 040012, 012, 0104000, 041305, 0201, 0110000, 060006, 4);
    /* In point mode it is `at`; several pairs; in relpoint a beam-off move. */
    assert_words("point\nmoveto 1,2\nrelpoint\nmoveto 4,4\nlongv\nlineto 5,5, 4,4", 0114000, 1, 2,
                 0130000, 0602, 0110000, 040001, 1, 060001, 020001);
    assert_words("longv\n.pos -5, 7\nlineto 0, 0", 0110000, 040005, 020007);
}

static void long_ways_are_split(void **state)
{
    (void)state;
    /* 200 units in short vectors of at most 63: four equal parts of 50. */
    assert_words("point\nat 0,0\nshortv\nlineto 200, 100", 0114000, 0, 0, 0104000, 054431, 054431,
                 054431, 054431);
    /* Parts that are no integers add up all the same: 100 = 50 + 50, 65 = 33 + 32. */
    assert_words("point\nat 0,0\nshortv\nlineto 65, 1", 0114000, 0, 0, 0104000,
                 040000 | 33 << 7 | 1, 040000 | 32 << 7);
    /* 4095 units in five long vectors of 819. */
    assert_words("longv\n.pos -2048, 0\nlineto 2047, 0", 0110000, 041463, 0, 041463, 0, 041463, 0,
                 041463, 0, 041463, 0);
    assert_words("longv\n.pos 0, 0\nlineto 1023, 0\nlineto 0, 0", 0110000, 041777, 0, 061777, 0);
}

/* ---- the DEC dialect ---- */

static void dec_names(void **state)
{
    (void)state;
    assert_words(".dialect dec\nCHAR,SHORTV,LONGV,POINT,GRAPHX,GRAPHY,RELATV", 0100000, 0104000,
                 0110000, 0114000, 0120000, 0124000, 0130000);
    assert_words(".dialect dec\nINT0,INT1,INT2,INT3,INT4,INT5,INT6,INT7", 02000, 02200, 02400,
                 02600, 03000, 03200, 03400, 03600);
    assert_words(".dialect dec\nLPOFF,LPON,BLKOFF,BLKON,LINE0,LINE1,LINE2,LINE3", 0100, 0140, 020,
                 030, 4, 5, 6, 7);
    assert_words(".dialect dec\nDJMP,DNOP,DSTOP,STATSA,SINON,SINOF,LPLITE,LPDARK,ITAL0,ITAL1,SYNC",
                 0160000, 0164000, 0172000, 0170000, 01400, 01000, 0200, 0300, 040, 060, 4);
    assert_words(".dialect dec\nSTATSB,INCR,INTX,MAXX,MAXY,MINUSX,MINUSY,MAXSX,MAXSY,MISVX,MISVY",
                 0174000, 0100, 040000, 01777, 01377, 020000, 020000, 017600, 077, 020000, 0100);
}

static void dec_expressions(void **state)
{
    (void)state;
    assert_words(".dialect dec\nPOINT!INT7!LPON\npoint|int7|lpon\nPOINT+INT7+LPON", 0117740,
                 0117740, 0117740);
    /* From left to right, integers, angle brackets group. */
    assert_words(".dialect dec\n2+3*4\n2+<3*4>\n17/2\n17&6\n10.+10\n-1\n^C7\n^D10\n^B101\n^O17",
                 024, 016, 7, 6, 022, 0177777, 0177770, 012, 5, 017);
    assert_words(".dialect dec\n'A\n\"AB\nX=5\nX+1\nX=X+2\nX", 0101, 041101, 6, 7);
    assert_words(".dialect dec\nDSTOP=173400\nDSTOP", 0173400);
}

static void dec_data(void **state)
{
    (void)state;
    assert_words(".dialect dec\n.WORD 1,2\n.BYTE 1,2,3\n.EVEN\n.ASCII /ABC/<15><12>\n.EVEN\n", 1, 2,
                 01001, 3, 041101, 06503, 012);
    assert_words(".dialect dec\n.ASCIZ \"AB\"\n.EVEN\n.BLKW 2\n.BLKB 1\n.BYTE 7", 041101, 0, 0, 0,
                 03400);
    assert_words(".dialect dec\n.REPT 3\n1\n.ENDR\n.TITLE what ever, \"it\n.WORD .", 1, 1, 1, 6);
    assert_words(".dialect dec\n. = 1000\n.WORD .\n.=.+2\n.dialect native\n.org 0o1002\n.word 5",
                 01000, 5);
}

static void dec_end(void **state)
{
    (void)state;
    struct df_program p;
    source_program(".dialect dec\n1\nGO: DSTOP\n.END GO\nthis is not read", &p);
    assert_int_equal(p.entry, 2);
    assert_int_equal(p.high, 4);
    df_program_free(&p);
}

/* The same picture in both dialects. */
static void both_dialects(void **state)
{
    (void)state;
    struct df_program native, dec;
    source_program(".org 0o1000\n"
                   "loop:  sync italics=off penlight=on\n"
                   "       point i=5 pen=off blink=off line=solid\n"
                   "       at 64, 128\n"
                   "       longv i=7 line=dotdash\n"
                   "       draw 128, 0\n"
                   "       draw 0, -64\n"
                   "       shortv pen=on\n"
                   "       draw -63, 63\n"
                   "       graphx\n"
                   "       step 3\n"
                   "       value 255\n"
                   "       char blink=on\n"
                   "       text \"HI!\"\n"
                   "       relpoint\n"
                   "       move 1, -1\n"
                   "       jump loop\n",
                   &native);
    source_program(".dialect dec\n"
                   "       .=1000\n"
                   "LOOP:  STATSA!SYNC!ITAL0!LPLITE\n"
                   "       POINT!INT5!LPOFF!BLKOFF!LINE0\n"
                   "       100,200\n"
                   "       LONGV!INT7!LINE3\n"
                   "       200!INTX,0\n"
                   "       0!INTX,100!MINUSY\n"
                   "       SHORTV!LPON\n"
                   "       INTX!MAXSX!MISVX!MAXSY\n"
                   "       GRAPHX\n"
                   "       STATSB!INCR!3\n"
                   "       377\n"
                   "       CHAR!BLKON\n"
                   "       .ASCII /HI!/\n"
                   "       .EVEN\n"
                   "       RELATV\n"
                   "       200!MISVY!1\n"
                   "       DJMP,LOOP\n",
                   &dec);
    assert_true(source_same(&native, &dec));
    df_program_free(&native);
    df_program_free(&dec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes),
        cmocka_unit_test(mode_options),
        cmocka_unit_test(point_data),
        cmocka_unit_test(long_data),
        cmocka_unit_test(short_data),
        cmocka_unit_test(graphplot_data),
        cmocka_unit_test(colours),
        cmocka_unit_test(text_data),
        cmocka_unit_test(status),
        cmocka_unit_test(jumps),
        cmocka_unit_test(raw_words),
        cmocka_unit_test(absolute_drawing),
        cmocka_unit_test(long_ways_are_split),
        cmocka_unit_test(dec_names),
        cmocka_unit_test(dec_expressions),
        cmocka_unit_test(dec_data),
        cmocka_unit_test(dec_end),
        cmocka_unit_test(both_dialects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
