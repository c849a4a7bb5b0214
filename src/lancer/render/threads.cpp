#include "lancer/render/threads.h"

#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

// TBB orders what happens before, in and after its tasks, but its binary is not instrumented. So the thread sanitizer does not look into this
// file (see src/CMakeLists.txt), and is told here what TBB does; everything else it checks itself.
#if defined(LANCER_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace lancer {

namespace {

#if defined(LANCER_THREAD_SANITIZER)
void hand_over(const void* what) { __tsan_release(const_cast<void*>(what)); }
void take_over(const void* what) { __tsan_acquire(const_cast<void*>(what)); }
#else
void hand_over(const void*) {}
void take_over(const void*) {}
#endif

}  // namespace

void run_on_threads(int threads, const std::function<void()>& work) {
    if (threads == 1) {
        work();
        return;
    }
    hand_over(&work);
    // TBB gives no more threads than the machine has unless it is told to.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        const auto run = [&](const tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i < range.end(); ++i) {
                take_over(&work);
                work();
                hand_over(&work);
            }
        };
        tbb::parallel_for(tbb::blocked_range<int>(0, threads, 1), run, tbb::simple_partitioner());
    });
    take_over(&work);
}

}  // namespace lancer
