#include "emu/board/uart_private.h"

static uint8_t line_status(const struct vm_uart *u)
{
    unsigned v = u->rx.count > 0 ? LSR_DATA : 0;

    v |= u->overrun ? LSR_OVERRUN : 0;
    v |= u->tx.count == 0 ? LSR_THR_EMPTY : 0;
    v |= u->tx.count == 0 && u->shift != VM_UART_SHIFTING ? LSR_EMPTY : 0;
    return (uint8_t)v;
}

/* Outside loopback a terminal that is always ready; in it, the outputs of MCR. */
static uint8_t modem_lines(uint8_t mcr)
{
    unsigned v = 0;

    if (!(mcr & MCR_LOOP))
        return MSR_CTS | MSR_DSR | MSR_DCD;
    v |= mcr & MCR_RTS ? MSR_CTS : 0;
    v |= mcr & MCR_DTR ? MSR_DSR : 0;
    v |= mcr & MCR_OUT1 ? MSR_RI : 0;
    v |= mcr & MCR_OUT2 ? MSR_DCD : 0;
    return (uint8_t)v;
}

/* A delta bit says that its line has changed; of RI, that it has gone off. */
static void write_modem_control(struct vm_uart *u, uint8_t value, uint64_t t)
{
    uint8_t before = modem_lines(u->mcr), after = modem_lines(value & MCR_BITS);
    unsigned changed = (before ^ after) & ~(unsigned)(after & MSR_RI);

    if (u->mcr & ~value & MCR_LOOP)
        vm_uart_listen(u, t);
    u->mcr = value & MCR_BITS;
    u->modem_delta |= (uint8_t)(changed >> 4);
}

/* The other bits take only together with the enable bit. */
static void write_fifo_control(struct vm_uart *u, uint8_t value, uint64_t t)
{
    bool changed = (value ^ u->fcr) & FCR_ENABLE;

    if (changed || (value & FCR_ENABLE && value & FCR_CLEAR_RX))
        vm_uart_clear_receiver(u, t);
    if (changed || (value & FCR_ENABLE && value & FCR_CLEAR_TX))
        vm_uart_clear_transmitter(u);
    u->fcr = value & FCR_ENABLE ? value & (FCR_ENABLE | FCR_TRIGGER) : 0;
}

static void write_interrupt_enable(struct vm_uart *u, uint8_t value)
{
    if ((value ^ u->ier) & IER_THR)
        u->thr_pending = value & IER_THR && u->tx.count == 0;
    u->ier = value & IER_BITS;
}

static uint8_t read_interrupt(struct vm_uart *u)
{
    uint8_t id = vm_uart_interrupt(u);

    if (id == IIR_THR)
        u->thr_pending = false;
    return (uint8_t)(id | (vm_uart_fifo(u) ? IIR_FIFO : 0));
}

static uint8_t read_line_status(struct vm_uart *u)
{
    uint8_t v = line_status(u);

    u->overrun = false;
    return v;
}

static uint8_t read_modem_status(struct vm_uart *u)
{
    uint8_t v = (uint8_t)(modem_lines(u->mcr) | u->modem_delta);

    u->modem_delta = 0;
    return v;
}

static uint8_t read_register(struct vm_uart *u, uint32_t offset, uint64_t t)
{
    bool latch = u->lcr & LCR_DLAB;

    switch (offset) {
    case UART_DATA:
        return latch ? (uint8_t)u->divisor : vm_uart_take(u, t);
    case UART_IER:
        return latch ? (uint8_t)(u->divisor >> 8) : u->ier;
    case UART_IIR:
        return read_interrupt(u);
    case UART_LCR:
        return u->lcr;
    case UART_MCR:
        return u->mcr;
    case UART_LSR:
        return read_line_status(u);
    case UART_MSR:
        return read_modem_status(u);
    default:
        return u->scr;
    }
}

bool vm_uart_read(struct vm_uart *u, uint32_t offset, uint32_t *value, uint64_t t)
{
    if (offset >= UART_REGISTERS)
        return false;
    vm_uart_event(u, t);
    *value = read_register(u, offset, t);
    vm_uart_settle(u, t);
    return true;
}

static void write_register(struct vm_uart *u, uint32_t offset, uint8_t value, uint64_t t)
{
    bool latch = u->lcr & LCR_DLAB;

    switch (offset) {
    case UART_DATA:
        if (latch)
            u->divisor = (uint16_t)((u->divisor & 0xFF00) | value);
        else
            vm_uart_put(u, value, t);
        break;
    case UART_IER:
        if (latch)
            u->divisor = (uint16_t)((u->divisor & 0xFF) | value << 8);
        else
            write_interrupt_enable(u, value);
        break;
    case UART_FCR:
        write_fifo_control(u, value, t);
        break;
    case UART_LCR:
        u->lcr = value;
        break;
    case UART_MCR:
        write_modem_control(u, value, t);
        break;
    case UART_SCR:
        u->scr = value;
        break;
    default: /* LSR and MSR: writes are for factory tests */
        break;
    }
}

bool vm_uart_write(struct vm_uart *u, uint32_t offset, uint32_t value, uint64_t t)
{
    if (offset >= UART_REGISTERS)
        return false;
    vm_uart_event(u, t);
    write_register(u, offset, (uint8_t)value, t);
    vm_uart_settle(u, t);
    return true;
}
