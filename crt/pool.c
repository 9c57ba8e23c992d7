#include "crt/pool.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

struct helper {
    struct crt_pool *pool;
    pthread_t thread;
    int worker;
};

struct crt_pool {
    pthread_mutex_t lock;
    pthread_cond_t start, finish;
    crt_pool_work *work;
    void *context;
    int count, next; /* indices handed out so far */
    int busy;        /* helpers that have not finished this round */
    unsigned round;
    bool stop;
    int helpers;
    struct helper helper[];
};

/* Takes indices until none is left. Called and left with the lock held. */
static void take_part(struct crt_pool *pool, int worker)
{
    while (pool->next < pool->count) {
        int index = pool->next++;
        pthread_mutex_unlock(&pool->lock);
        pool->work(pool->context, index, worker);
        pthread_mutex_lock(&pool->lock);
    }
}

static void *helper_main(void *argument)
{
    struct helper *helper = argument;
    struct crt_pool *pool = helper->pool;
    unsigned seen = 0;
    pthread_mutex_lock(&pool->lock);
    for (;;) {
        while (!pool->stop && pool->round == seen)
            pthread_cond_wait(&pool->start, &pool->lock);
        if (pool->stop)
            break;
        seen = pool->round;
        take_part(pool, helper->worker);
        if (--pool->busy == 0)
            pthread_cond_signal(&pool->finish);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

struct crt_pool *crt_pool_create(int threads, struct crt_error *err)
{
    struct crt_pool *pool = calloc(1, sizeof *pool + (size_t)threads * sizeof pool->helper[0]);
    if (!pool) {
        crt_fail(err, "out of memory for %d threads; use fewer", threads);
        return NULL;
    }
    pthread_mutex_init(&pool->lock, NULL);
    pthread_cond_init(&pool->start, NULL);
    pthread_cond_init(&pool->finish, NULL);
    for (int i = 0; i < threads - 1; i++) {
        struct helper *helper = &pool->helper[i];
        *helper = (struct helper){.pool = pool, .worker = i + 1};
        int trouble = pthread_create(&helper->thread, NULL, helper_main, helper);
        if (trouble) {
            crt_fail(err, "cannot start thread %d of %d (%s); use fewer threads", i + 1, threads,
                     strerror(trouble));
            crt_pool_destroy(pool);
            return NULL;
        }
        pool->helpers++;
    }
    return pool;
}

void crt_pool_destroy(struct crt_pool *pool)
{
    if (!pool)
        return;
    pthread_mutex_lock(&pool->lock);
    pool->stop = true;
    pthread_cond_broadcast(&pool->start);
    pthread_mutex_unlock(&pool->lock);
    for (int i = 0; i < pool->helpers; i++)
        pthread_join(pool->helper[i].thread, NULL);
    pthread_cond_destroy(&pool->finish);
    pthread_cond_destroy(&pool->start);
    pthread_mutex_destroy(&pool->lock);
    free(pool);
}

void crt_pool_run(struct crt_pool *pool, crt_pool_work *work, void *context, int count)
{
    if (!pool) {
        for (int i = 0; i < count; i++)
            work(context, i, 0);
        return;
    }
    pthread_mutex_lock(&pool->lock);
    pool->work = work;
    pool->context = context;
    pool->count = count;
    pool->next = 0;
    pool->busy = pool->helpers;
    pool->round++;
    pthread_cond_broadcast(&pool->start);
    take_part(pool, 0);
    while (pool->busy > 0)
        pthread_cond_wait(&pool->finish, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
}
