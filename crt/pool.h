/* pool.h — worker threads that share out numbered pieces of work.
 *
 * Models:     crt_pool_run calls work(context, index, worker) once for every index below count, on
 *             any thread; the caller is worker 0 and takes part. It returns when all are done. With
 *             one thread there is no pool: NULL runs everything in order.
 * Ownership:  create/destroy pair; the context stays the caller's.
 * Errors:     no threads to be had: NULL and a sentence.
 */
#ifndef CRT_POOL_H
#define CRT_POOL_H

#include "crt/error.h"

struct crt_pool;

typedef void crt_pool_work(void *context, int index, int worker);

struct crt_pool *crt_pool_create(int threads, struct crt_error *err);
void crt_pool_destroy(struct crt_pool *pool);
void crt_pool_run(struct crt_pool *pool, crt_pool_work *work, void *context, int count);

#endif
