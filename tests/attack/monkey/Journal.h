#pragma once

#include "core/io/system/OpenFile.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::attack {

/// Seconds of a clock that never goes back and that all processes of the machine share.
double monotonicTime();

/// Notes what happens in the editor, for the process that kills it: lines of fields with tabs between them, the time
/// and a kind in front. Each line is one write(), so that a kill loses none that was written, and writes none in
/// part.
class JournalWriter {
public:
    explicit JournalWriter(const std::filesystem::path& path);

    void note(std::string_view kind, const std::vector<std::string>& fields = {});
    /// Notes a broken promise and ends the process.
    [[noreturn]] void fail(const std::string& fault);

private:
    OpenFile m_file;
};

/// A document from one change to the next.
struct DocumentState {
    double time = 0.0;  // s, of monotonicTime(), just after the change
    std::string hash;   // of the project's text
    bool isModified = false;
    std::string path;  // of its file; empty: none
};

struct JournaledDocument {
    std::vector<DocumentState> states;
    std::size_t restored = 0;  // number of states before the monkey began
    bool isClosed = false;
    bool isReplaced = false;  // it was saved, or its content is being replaced by that of a file, as the user wanted
};

struct JournaledInterval {
    double time = 0.0;
    int seconds = 0;  // 0: no backups
};

/// What a journal says. The kinds of lines are the names of the fields.
struct Journal {
    std::map<int, JournaledDocument> documents;  // state, file, close
    std::vector<double> beats;                   // beat, busy: times at which the event loop fired a timer
    std::vector<double> idleBeats;               // beat: with no backup being written
    std::vector<JournaledInterval> intervals;    // from a change to its backup
    std::vector<std::string> offers;             // questions whether to restore a backup
    std::vector<std::string> events;             // what the monkey did
    std::string fault;
    std::size_t changes = 0;
    bool isReady = false;  // backups were restored, the monkey begins
    bool isDone = false;   // the editor ended as it should
};

/// Reads a journal; empty if there is none yet.
Journal readJournal(const std::filesystem::path& path);

}  // namespace rubble::attack
