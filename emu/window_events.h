/* window_events.h — GLFW's callbacks gathered into a queue of struct vm_event; private to the
 * window.
 *
 * Ownership:  the queue is the window handle's user pointer; destroy the handle first.
 * Errors:     an event that finds no memory is lost.
 */
#ifndef VM_WINDOW_EVENTS_H
#define VM_WINDOW_EVENTS_H

#include "emu/window.h"

struct GLFWwindow;
struct vm_event_queue;

/* Installs the callbacks. NULL when out of memory. */
struct vm_event_queue *vm_event_queue_create(struct GLFWwindow *handle);
void vm_event_queue_destroy(struct vm_event_queue *queue);

/* Forgets the events already returned, and the file names they carried. */
void vm_event_queue_rewind(struct vm_event_queue *queue);
bool vm_event_queue_next(struct vm_event_queue *queue, struct vm_event *event);

#endif
