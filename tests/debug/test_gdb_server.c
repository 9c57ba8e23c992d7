/* The debugger's door: addresses, one client at a time, who vanishes, replies that nobody reads. */
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmocka.h>

#include "emu/debug/gdb_server.h"
#include "tests/debug/gdb_bare.h"

#define PATIENCE_MS 2000

struct place {
    struct bare bare;
    struct vm_gdb *gdb;
};

static int begin(void **state)
{
    struct crt_error err;
    struct place *p = malloc(sizeof *p);
    assert_non_null(p);
    assert_true(bare_init(&p->bare, bare_timer, sizeof bare_timer / 4, 0));
    p->gdb = vm_gdb_open("127.0.0.1:0", false, &err);
    assert_non_null(p->gdb);
    *state = p;
    return 0;
}

static int end(void **state)
{
    struct place *p = *state;
    vm_gdb_close(p->gdb);
    bare_free(&p->bare);
    free(p);
    return 0;
}

static int connect_to(const struct place *p)
{
    const char *port = strrchr(vm_gdb_place(p->gdb), ':') + 1;
    struct sockaddr_in at = {.sin_family = AF_INET,
                             .sin_port = htons((uint16_t)atoi(port)),
                             .sin_addr = {htonl(INADDR_LOOPBACK)}};
    int fd = socket(AF_INET, SOCK_STREAM, 0);
    assert_int_equal(connect(fd, (struct sockaddr *)&at, sizeof at), 0);
    return fd;
}

static enum vm_gdb_ran run(struct place *p, uint64_t clocks)
{
    return vm_gdb_run(p->gdb, &p->bare.session.target, p->bare.cpu.cycle + clocks, 20);
}

/* Sends bytes and runs until an answer of this length has come; "" when the connection ends. */
static const char *talk(struct place *p, int fd, const char *bytes, size_t answer)
{
    static char text[512];
    size_t got = 0;
    assert_int_equal(send(fd, bytes, strlen(bytes), MSG_NOSIGNAL), (ssize_t)strlen(bytes));
    for (int i = 0; got < answer && i < 200; i++) {
        struct pollfd in = {.fd = fd, .events = POLLIN};
        run(p, 1000);
        if (poll(&in, 1, 5) <= 0)
            continue;
        ssize_t n = recv(fd, text + got, answer - got, 0);
        if (n <= 0)
            break;
        got += (size_t)n;
    }
    text[got] = '\0';
    return text;
}

static bool closed(int fd)
{
    char byte;
    struct pollfd in = {.fd = fd, .events = POLLIN};
    return poll(&in, 1, PATIENCE_MS) == 1 && recv(fd, &byte, 1, 0) <= 0;
}

/* ---- addresses ---- */

static void addresses(void **state)
{
    (void)state;
    static const struct {
        const char *place, *says;
        bool anywhere;
    } cases[] = {
        {"1234", "give ADDRESS:PORT", false},
        {"127.0.0.1:", "give ADDRESS:PORT", false},
        {"127.0.0.1:65536", "give ADDRESS:PORT", false},
        {"127.0.0.1:99999999999", "give ADDRESS:PORT", false},
        {"127.0.0.1:-1", "give ADDRESS:PORT", false},
        {"127.0.0.1:12a", "give ADDRESS:PORT", false},
        {"a.very.long.host.name.indeed:1", "give ADDRESS:PORT", false},
        {"example.org:1234", "is no IPv4 address", false},
        {"127.0.0.256:1234", "is no IPv4 address", false},
        {"0.0.0.0:0", "--gdb-anywhere", false},
        {"192.0.2.1:0", "--gdb-anywhere", false},
        {"192.0.2.1:0", "cannot listen there", true}, /* an address for documentation */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct crt_error err = {""};
        assert_null(vm_gdb_open(cases[i].place, cases[i].anywhere, &err));
        if (!strstr(err.text, cases[i].says)) {
            print_error("%s: %s\n", cases[i].place, err.text);
            fail();
        }
    }
    static const char *const good[] = {"127.0.0.1:0", ":0", "localhost:0", "127.9.8.7:0"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct crt_error err = {""};
        struct vm_gdb *gdb = vm_gdb_open(good[i], false, &err);
        assert_non_null(gdb);
        assert_memory_equal(vm_gdb_place(gdb), "127.", 4);
        struct vm_gdb *again = vm_gdb_open(vm_gdb_place(gdb), false, &err);
        assert_null(again);
        assert_non_null(strstr(err.text, "cannot listen there"));
        vm_gdb_close(gdb);
    }
    vm_gdb_close(NULL);
}

/* ---- clients ---- */

static void waits_for_the_first(void **state)
{
    struct place *p = *state;
    assert_int_equal(run(p, 1000), VM_GDB_HELD);
    assert_int_equal(p->bare.cpu.cycle, 0);
    int fd = connect_to(p);
    assert_int_equal(run(p, 1000), VM_GDB_HELD);
    assert_string_equal(talk(p, fd, "$qC#b4", 8), "+$QC1#c5");
    assert_int_equal(p->bare.cpu.cycle, 0);
    assert_string_equal(talk(p, fd, "+$Z0,80000024,4#a4", 7), "+$OK#9a");
    assert_memory_equal(talk(p, fd, "+$c#63", 11), "+$T0502:000", 11);
    assert_int_equal(p->bare.cpu.pc, 0x80000024);
    close(fd);
}

static void vanishing(void **state)
{
    struct place *p = *state;
    int fd = connect_to(p);
    assert_string_equal(talk(p, fd, "$Z0,80000024,4#a4", 7), "+$OK#9a");
    close(fd);
    while (run(p, 1000) == VM_GDB_HELD)
        ;
    assert_int_equal(run(p, 1000), VM_GDB_RAN);
    uint64_t cycle = p->bare.cpu.cycle;
    assert_true(cycle >= 1000);
    fd = connect_to(p); /* the next one stops it where it is */
    while (run(p, 1000) != VM_GDB_HELD)
        ;
    assert_string_equal(talk(p, fd, "$qC#b4", 8), "+$QC1#c5");
    close(fd);
}

/* A client that dies with a reply on its way: no signal ends us. */
static void dying_with_replies(void **state)
{
    struct place *p = *state;
    struct linger now = {1, 0};
    for (int i = 0; i < 20; i++) {
        int fd = connect_to(p);
        for (int n = 0; n < 50; n++)
            assert_true(send(fd, "$m80000000,2000#e3", 18, MSG_NOSIGNAL) == 18);
        if (i % 2 == 0) { /* in the middle, by a reset */
            setsockopt(fd, SOL_SOCKET, SO_LINGER, &now, sizeof now);
            run(p, 10);
        } /* else before the first reply, which nobody takes */
        close(fd);
        run(p, 10);
    }
    while (run(p, 1000) == VM_GDB_HELD)
        ;
    assert_int_equal(run(p, 1000), VM_GDB_RAN);
}

static void one_at_a_time(void **state)
{
    struct place *p = *state;
    int first = connect_to(p);
    assert_string_equal(talk(p, first, "$qC#b4", 8), "+$QC1#c5");
    int second = connect_to(p);
    run(p, 10);
    assert_true(closed(second));
    assert_string_equal(talk(p, first, "$qC#b4", 8), "+$QC1#c5");
    close(second);
    close(first);
}

static void detaching_and_interrupting(void **state)
{
    struct place *p = *state;
    int fd = connect_to(p);
    assert_string_equal(talk(p, fd, "$c#63", 1), "+");
    assert_int_equal(run(p, 5000), VM_GDB_RAN);
    assert_memory_equal(talk(p, fd, "\x03", 10), "$T0202:000", 10);
    assert_int_equal(run(p, 1000), VM_GDB_HELD);
    char rest[256];
    assert_true(recv(fd, rest, sizeof rest, 0) > 0);
    assert_string_equal(talk(p, fd, "$D#44", 7), "+$OK#9a");
    assert_true(closed(fd));
    assert_int_equal(run(p, 1000), VM_GDB_RAN);
    close(fd);
}

static void endings(void **state)
{
    struct place *p = *state;
    int fd = connect_to(p);
    assert_string_equal(talk(p, fd, "$M80000024,4:23200010#fd", 7),
                        "+$OK#9a"); /* sw zero,0x100(zero) */
    assert_string_equal(talk(p, fd, "$c#63", 8), "+$W00#b7");
    assert_int_equal(run(p, 10), VM_GDB_OVER);
    p->bare.over = false;
    assert_string_equal(talk(p, fd, "$k#6b", 1), "+");
    assert_int_equal(run(p, 10), VM_GDB_OVER);
    close(fd);
}

/* A trap that nobody handles ends a run that nobody debugs; a client can still look at it. */
static void lost_alone(void **state)
{
    struct place *p = *state;
    int fd = connect_to(p);
    assert_string_equal(talk(p, fd, "$M80000024,4:00000000#f5", 7), "+$OK#9a");
    assert_string_equal(talk(p, fd, "$M8000000c,4:13000000#26", 7), "+$OK#9a"); /* for csrw mtvec */
    assert_string_equal(talk(p, fd, "$D#44", 7), "+$OK#9a");
    assert_true(closed(fd));
    close(fd);
    enum vm_gdb_ran ran = VM_GDB_RAN;
    for (int i = 0; i < 20 && ran != VM_GDB_OVER; i++)
        ran = run(p, 1000);
    assert_int_equal(ran, VM_GDB_OVER);
    assert_int_equal(p->bare.cpu.state, RV_HALTED);
    fd = connect_to(p);
    for (int i = 0; i < 20 && ran != VM_GDB_HELD; i++)
        ran = run(p, 1000);
    assert_int_equal(ran, VM_GDB_HELD);
    assert_memory_equal(talk(p, fd, "$c#63", 5), "+$T04", 5);
    close(fd);
}

/* The front end ends while the program runs. */
static void ended_from_outside(void **state)
{
    struct place *p = *state;
    struct crt_error err;
    int fd = connect_to(p);
    assert_string_equal(talk(p, fd, "$c#63", 1), "+");
    p->bare.over = true; /* not asked: the target may be gone */
    vm_gdb_close(p->gdb);
    char text[16] = "";
    assert_int_equal(recv(fd, text, sizeof text, 0), 7);
    assert_memory_equal(text, "$X0f#ee", 7);
    assert_true(closed(fd));
    close(fd);
    p->gdb = vm_gdb_open("127.0.0.1:0", false, &err);
    assert_non_null(p->gdb);
}

/* A client that only asks cannot hang the front end, and loses no reply once it reads. */
static void asking_without_reading(void **state)
{
    struct place *p = *state;
    static const char question[] = "$m80000000,2000#e3";
    int fd = connect_to(p), asked = 0;
    run(p, 10);
    for (; asked < 2000; asked++) {
        struct pollfd out = {.fd = fd, .events = POLLOUT};
        if (poll(&out, 1, 0) != 1 ||
            send(fd, question, sizeof question - 1, MSG_NOSIGNAL | MSG_DONTWAIT) !=
                (ssize_t)sizeof question - 1)
            break;
        if (asked % 16 == 0)
            assert_int_equal(vm_gdb_run(p->gdb, &p->bare.session.target, 10, 0), VM_GDB_HELD);
    }
    assert_true(asked > 100);
    size_t expected = (size_t)asked * (1 + 4 + 2 * BARE_SIZE), got = 0;
    static char text[65536];
    for (int idle = 0; got < expected && idle < 100;) {
        struct pollfd in = {.fd = fd, .events = POLLIN};
        vm_gdb_run(p->gdb, &p->bare.session.target, 10, 0);
        idle = poll(&in, 1, 5) == 1 ? 0 : idle + 1;
        if (idle == 0)
            got += (size_t)recv(fd, text, sizeof text, 0);
    }
    assert_int_equal(got, expected);
    close(fd);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(addresses),
        TEST(waits_for_the_first),
        TEST(vanishing),
        TEST(dying_with_replies),
        TEST(one_at_a_time),
        TEST(detaching_and_interrupting),
        TEST(endings),
        TEST(lost_alone),
        TEST(ended_from_outside),
        TEST(asking_without_reading),
    };
    return cmocka_run_group_tests_name("gdb_server", tests, NULL, NULL);
}
