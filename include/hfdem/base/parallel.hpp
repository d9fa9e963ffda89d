/// @file
/// Loops over threads. OpenMP is optional: without it everything runs on one thread, and the
/// results are the same bits either way, because no loop sums across threads.
#pragma once

#include <algorithm>
#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace hfdem {

/// Number of threads that a loop can use on this machine.
inline int available_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

/// Splits [0, count) into chunks of `grain` and calls `f(chunk, begin, end)` for each.
/// `f` may write only to places that belong to its own chunk.
template <class F>
void for_chunks(std::size_t count, std::size_t grain, [[maybe_unused]] int threads, F&& f) {
  const std::size_t chunks = (count + grain - 1) / grain;
  const auto run = [&](std::size_t c) { f(c, c * grain, std::min(count, (c + 1) * grain)); };
#ifdef _OPENMP
  constexpr std::size_t few = 8;  // done sooner by one thread than others can be woken
  if (threads > 1 && chunks > few) {
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::size_t c = 0; c < chunks; ++c) run(c);
    return;
  }
#endif
  for (std::size_t c = 0; c < chunks; ++c) run(c);
}

/// Calls `f(part)` for every part, each on a thread of its own, which is the same one every time
/// and finds its data in its caches.
template <class F>
void for_parts(std::size_t parts, F&& f) {
#ifdef _OPENMP
  if (parts > 1) {
#pragma omp parallel for schedule(static, 1) num_threads(static_cast <int>(parts))
    for (std::size_t part = 0; part < parts; ++part) f(part);
    return;
  }
#endif
  for (std::size_t part = 0; part < parts; ++part) f(part);
}

/// Calls `f(task)` for every task, each on one thread, the next one as soon as a thread is free:
/// for few long tasks that share nothing. `f` must not throw.
template <class F>
void for_tasks(std::size_t count, [[maybe_unused]] int threads, F&& f) {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
#endif
  for (std::size_t task = 0; task < count; ++task) f(task);
}

}  // namespace hfdem
