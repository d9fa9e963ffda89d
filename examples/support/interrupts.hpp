/// @file
/// Being asked to stop: by Ctrl-C (SIGINT), or as batch systems do before they kill (SIGTERM).
#pragma once

#include <csignal>

namespace hfdem::support {

namespace detail {
inline volatile std::sig_atomic_t interrupted = 0;
}

/// From now on these signals are only noted, so that the program can stop where it loses nothing.
/// A second one ends it at once.
inline void note_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;  // as a shell script sets it for what runs behind
    action.sa_handler = [](int) { detail::interrupted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(signal, &action, nullptr);
  }
}

/// Whether the program has been asked to stop.
inline bool interrupted() { return detail::interrupted != 0; }

}  // namespace hfdem::support
