// Runs the same work on many threads.
#pragma once

#include <functional>

namespace lancer {

// Calls `work` from `threads` threads at once, the caller's among them, and returns when all are done; when fewer threads can be had, some call it
// several times. An exception from one of them is thrown again here.
void run_on_threads(int threads, const std::function<void()>& work);

}  // namespace lancer
