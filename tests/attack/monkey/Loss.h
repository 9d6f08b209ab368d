#pragma once

#include "tests/attack/monkey/Journal.h"

#include <optional>
#include <set>
#include <string>

namespace rubble::attack {

/// Changes of a document that were lost when its editor was killed.
struct Loss {
    double since = 0.0;  // time of the oldest of them
    /// They had to be in a backup: they were in one when the editor was started, or the interval had passed, with the
    /// tolerance of Qt's timers, and the event loop has run since, with no backup being written.
    bool isDue = false;
};

/// What was lost of a document; `recovered` holds the hashes of what is on the disk or was restored. Nothing if the
/// last state is among these, if it was an unchanged project without a file, or if the document was closed or replaced.
///
/// No allowance is made for a busy machine: a backup is due when the event loop has run twice after the interval
/// without one being written, once to start writing it and once to note that it is. The thread that writes may have
/// to wait for a processor; how long the event loop was held up is measured on its own.
std::optional<Loss> lossOf(const Journal& journal, const JournaledDocument& document,
                           const std::set<std::string>& recovered);

/// Whether the last state of a document is in no file of its own.
bool hasUnsavedWork(const JournaledDocument& document);

/// The longest time for which the event loop did not run, s.
double longestPause(const Journal& journal);

}  // namespace rubble::attack
