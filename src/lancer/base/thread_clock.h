// How much work a thread has done, whatever else the machine does meanwhile.
#pragma once

namespace lancer {

// Seconds that the calling thread has spent on a processor.
double thread_seconds();

}  // namespace lancer
