#include "emu/debug/gdb_server.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "emu/debug/gdb_session.h"

#define FLUSH_MS   1000 /* how long a last word may take to leave */
#define MOST_LOOKS 100  /* a client that never falls silent does not keep the front end waiting */

struct vm_gdb {
    int listener, client; /* client: -1 when there is none */
    bool waiting;         /* nobody has come yet */
    char place[INET_ADDRSTRLEN + 8];
    unsigned port;
    size_t pending_size; /* bytes received that the session has not taken */
    uint8_t pending[4096];
    struct vm_gdb_session session;
};

/* ---- opening ---- */

static bool parse_port(const char *text, uint16_t *port)
{
    unsigned long value = 0;
    if (!*text || strlen(text) > 5)
        return false;
    for (; *text; text++) {
        if (*text < '0' || *text > '9')
            return false;
        value = 10 * value + (unsigned long)(*text - '0');
    }
    *port = (uint16_t)value;
    return value <= UINT16_MAX;
}

static bool parse_place(const char *place, struct sockaddr_in *at, struct crt_error *err)
{
    char host[INET_ADDRSTRLEN] = "127.0.0.1";
    const char *colon = strrchr(place, ':');
    uint16_t port;
    *at = (struct sockaddr_in){.sin_family = AF_INET};
    size_t length = colon ? (size_t)(colon - place) : 0;
    if (!colon || !parse_port(colon + 1, &port) || length >= sizeof host)
        return crt_fail(err, "--gdb %.100s: give ADDRESS:PORT, as in 127.0.0.1:1234", place);
    if (length > 0 && strncmp(place, "localhost:", length + 1) != 0) {
        memcpy(host, place, length);
        host[length] = '\0';
    }
    at->sin_port = htons(port);
    if (inet_pton(AF_INET, host, &at->sin_addr) == 1)
        return true;
    return crt_fail(err,
                    "--gdb %.100s: %s is no IPv4 address; give one, as in 127.0.0.1:1234, or "
                    "localhost",
                    place, host);
}

static bool check_place(const char *place, const struct sockaddr_in *at, bool anywhere,
                        struct crt_error *err)
{
    if (anywhere || ntohl(at->sin_addr.s_addr) >> 24 == 127)
        return true;
    return crt_fail(err,
                    "--gdb %.100s lets other machines control the program; use 127.0.0.1, or give "
                    "--gdb-anywhere as well if that is meant",
                    place);
}

static bool nonblocking(int fd)
{
    int flags = fcntl(fd, F_GETFL);
    return flags >= 0 && fcntl(fd, F_SETFL, flags | O_NONBLOCK) == 0 &&
           fcntl(fd, F_SETFD, FD_CLOEXEC) == 0;
}

static bool listen_at(struct vm_gdb *gdb, struct sockaddr_in *at)
{
    socklen_t size = sizeof *at;
    char host[INET_ADDRSTRLEN];
    gdb->listener = socket(AF_INET, SOCK_STREAM, 0);
    if (gdb->listener < 0 ||
        setsockopt(gdb->listener, SOL_SOCKET, SO_REUSEADDR, &(int){1}, sizeof(int)) != 0 ||
        bind(gdb->listener, (struct sockaddr *)at, sizeof *at) != 0 ||
        listen(gdb->listener, 4) != 0 || !nonblocking(gdb->listener) ||
        getsockname(gdb->listener, (struct sockaddr *)at, &size) != 0 ||
        !inet_ntop(AF_INET, &at->sin_addr, host, sizeof host))
        return false;
    gdb->port = ntohs(at->sin_port);
    snprintf(gdb->place, sizeof gdb->place, "%s:%u", host, gdb->port);
    return true;
}

bool vm_gdb_check(const char *place, bool anywhere, struct crt_error *err)
{
    struct sockaddr_in at;
    return parse_place(place, &at, err) && check_place(place, &at, anywhere, err);
}

struct vm_gdb *vm_gdb_open(const char *place, bool anywhere, struct crt_error *err)
{
    struct sockaddr_in at;
    if (!parse_place(place, &at, err) || !check_place(place, &at, anywhere, err))
        return NULL;
    struct vm_gdb *gdb = calloc(1, sizeof *gdb);
    if (!gdb) {
        crt_fail(err, "out of memory for the debugger's connection; end other programs");
        return NULL;
    }
    gdb->client = -1;
    gdb->waiting = true;
    if (listen_at(gdb, &at))
        return gdb;
    crt_fail(err, "--gdb %.100s: cannot listen there: %s; another port may do, 0 is any", place,
             strerror(errno));
    if (gdb->listener >= 0)
        close(gdb->listener);
    free(gdb);
    return NULL;
}

const char *vm_gdb_place(const struct vm_gdb *gdb)
{
    return gdb->place;
}

void vm_gdb_announce(const struct vm_gdb *gdb, const char *file)
{
    size_t length = strlen(file);
    if (length < 4 || strcmp(file + length - 4, ".elf") != 0)
        file = "FIRMWARE.elf"; /* a display file that brings it along */
    fprintf(stderr,
            "waiting for gdb at %s; connect with: gdb-multiarch %s -ex 'target remote :%u'\n",
            gdb->place, file, gdb->port);
}

/* ---- the connection ---- */

static void drop(struct vm_gdb *gdb)
{
    if (gdb->client >= 0)
        close(gdb->client);
    gdb->client = -1;
}

static void let_in(struct vm_gdb *gdb, const struct vm_gdb_target *target)
{
    int fd = accept(gdb->listener, NULL, NULL);
    if (fd < 0)
        return;
    if (gdb->client >= 0 || !nonblocking(fd)) {
        close(fd);
        return;
    }
    /* Packets are small and waited for. */
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &(int){1}, sizeof(int));
    gdb->client = fd;
    gdb->waiting = false;
    gdb->pending_size = 0;
    vm_gdb_session_begin(&gdb->session, target);
}

/* Not yet, rather than never. */
static bool later(void)
{
    return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

static void read_client(struct vm_gdb *gdb)
{
    ssize_t got = recv(gdb->client, gdb->pending + gdb->pending_size,
                       sizeof gdb->pending - gdb->pending_size, 0);
    if (got > 0)
        gdb->pending_size += (size_t)got;
    else if (got == 0 || !later())
        drop(gdb);
}

/* How much has gone. */
static size_t write_client(struct vm_gdb *gdb)
{
    size_t size;
    const uint8_t *bytes = vm_gdb_session_output(&gdb->session, &size);
    if (gdb->client < 0 || size == 0)
        return 0;
    ssize_t put = send(gdb->client, bytes, size, MSG_NOSIGNAL);
    if (put < 0 && !later())
        drop(gdb);
    if (put <= 0)
        return 0;
    vm_gdb_session_sent(&gdb->session, (size_t)put);
    return (size_t)put;
}

/* What has come is taken as long as the replies to it leave. */
static void serve(struct vm_gdb *gdb)
{
    size_t taken, put;
    do {
        taken = vm_gdb_session_feed(&gdb->session, gdb->pending, gdb->pending_size);
        gdb->pending_size -= taken;
        memmove(gdb->pending, gdb->pending + taken, gdb->pending_size);
        put = write_client(gdb);
    } while (gdb->client >= 0 && taken + put > 0 && gdb->pending_size > 0);
}

static void flush(struct vm_gdb *gdb)
{
    size_t size;
    write_client(gdb);
    vm_gdb_session_output(&gdb->session, &size);
    while (gdb->client >= 0 && size > 0) {
        struct pollfd fd = {.fd = gdb->client, .events = POLLOUT};
        if (poll(&fd, 1, FLUSH_MS) <= 0)
            return;
        write_client(gdb);
        vm_gdb_session_output(&gdb->session, &size);
    }
}

/* Waits up to wait_ms for something to happen, and serves it; false when nothing did. */
static bool look(struct vm_gdb *gdb, const struct vm_gdb_target *target, int wait_ms)
{
    size_t size = 0;
    struct pollfd fds[2] = {{.fd = gdb->listener, .events = POLLIN}, {.fd = gdb->client}};
    bool room = gdb->pending_size < sizeof gdb->pending;
    if (gdb->client >= 0) {
        gdb->session.target = *target;
        vm_gdb_session_output(&gdb->session, &size);
        fds[1].events = (short)((room ? POLLIN : 0) | (size > 0 ? POLLOUT : 0));
    }
    if (poll(fds, 2, wait_ms) <= 0)
        return false;
    if (room && fds[1].revents & (POLLIN | POLLHUP | POLLERR))
        read_client(gdb);
    if (gdb->client >= 0)
        serve(gdb);
    if (gdb->client >= 0 && gdb->session.state == VM_GDB_FREE) {
        flush(gdb);
        drop(gdb);
    }
    if (fds[0].revents & POLLIN)
        let_in(gdb, target);
    return true;
}

void vm_gdb_close(struct vm_gdb *gdb)
{
    if (!gdb)
        return;
    if (gdb->client >= 0) {
        vm_gdb_session_end(&gdb->session);
        flush(gdb);
    }
    drop(gdb);
    close(gdb->listener);
    free(gdb);
}

/* ---- running ---- */

bool vm_gdb_killed(const struct vm_gdb *gdb)
{
    return gdb->client >= 0 && gdb->session.state == VM_GDB_KILLED;
}

static bool over(struct vm_gdb *gdb, const struct vm_gdb_target *target)
{
    int status;
    bool lost = target->cpu->state == RV_HALTED && gdb->client < 0 && !gdb->waiting;
    return vm_gdb_killed(gdb) || lost || target->exited(target->ctx, &status);
}

/* One slice with nobody there. */
static void run_alone(const struct vm_gdb_target *target, uint64_t until)
{
    uint64_t now = target->now(target->ctx);
    target->run(target->ctx, until - now > target->slice ? now + target->slice : until);
}

/* Time passes towards `until`, or back; false when it cannot: the client has to read first. */
static bool run_session(struct vm_gdb *gdb, const struct vm_gdb_target *target, uint64_t until)
{
    uint64_t now = target->now(target->ctx);
    vm_gdb_session_run(&gdb->session, until);
    return gdb->session.state != VM_GDB_RUNNING || target->now(target->ctx) != now;
}

static bool arrived(const struct vm_gdb *gdb, const struct vm_gdb_target *target, uint64_t until)
{
    bool back = gdb->client >= 0 && vm_gdb_goes_back(&gdb->session);
    return !back && target->now(target->ctx) >= until;
}

enum vm_gdb_ran vm_gdb_run(struct vm_gdb *gdb, const struct vm_gdb_target *target, uint64_t until,
                           int wait_ms)
{
    look(gdb, target, 0);
    for (int looks = 0; !over(gdb, target);) {
        bool held = gdb->waiting || (gdb->client >= 0 && gdb->session.state == VM_GDB_STOPPED);
        if (!held && arrived(gdb, target, until))
            return VM_GDB_RAN;
        if (!held && gdb->client >= 0)
            held = !run_session(gdb, target, until);
        else if (!held)
            run_alone(target, until);
        if (!held)
            look(gdb, target, 0);
        else if (looks++ == MOST_LOOKS || !look(gdb, target, wait_ms))
            return VM_GDB_HELD;
    }
    flush(gdb);
    return VM_GDB_OVER;
}
