#include "tests/attack/monkey/Journal.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace rubble::attack {
namespace {

constexpr int kFaultExit = 3;

std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields;
    std::size_t start = 0;
    for (std::size_t end = line.find('\t'); end != std::string::npos; end = line.find('\t', start)) {
        fields.push_back(line.substr(start, end - start));
        start = end + 1;
    }
    fields.push_back(line.substr(start));
    return fields;
}

void addState(Journal& journal, double time, const std::vector<std::string>& fields) {
    JournaledDocument& document = journal.documents[std::stoi(fields[2])];
    document.isReplaced = false;
    std::vector<DocumentState>& states = document.states;
    if (!states.empty() && states.back().hash != fields[3]) ++journal.changes;
    states.push_back({.time = time, .hash = fields[3], .isModified = fields[4] == "1", .path = fields[5]});
}

void addLine(Journal& journal, const std::vector<std::string>& fields) {
    const double time = std::stod(fields[0]);
    const std::string& kind = fields[1];
    if (kind == "state") addState(journal, time, fields);
    if (kind == "file") journal.documents[std::stoi(fields[2])].isReplaced = true;
    if (kind == "close") journal.documents[std::stoi(fields[2])].isClosed = true;
    if (kind == "beat" || kind == "busy") journal.beats.push_back(time);
    if (kind == "beat") journal.idleBeats.push_back(time);
    if (kind == "interval") journal.intervals.push_back({time, std::stoi(fields[2])});
    if (kind == "offer") journal.offers.push_back(fields[2]);
    if (kind == "event") journal.events.push_back(fields[2]);
    if (kind == "fault") journal.fault = fields[2];
    if (kind == "ready") {
        journal.isReady = true;
        for (auto& [number, document] : journal.documents) document.restored = document.states.size();
    }
    if (kind == "done") journal.isDone = true;
}

}  // namespace

double monotonicTime() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

JournalWriter::JournalWriter(const std::filesystem::path& path) : m_file(path, O_WRONLY | O_CREAT | O_APPEND, 0600) {
    if (m_file.isOpen()) return;
    std::perror(path.c_str());
    std::exit(2);
}

void JournalWriter::note(std::string_view kind, const std::vector<std::string>& fields) {
    char time[32];
    std::snprintf(time, sizeof time, "%.6f\t", monotonicTime());
    std::string line = time + std::string(kind);
    for (const std::string& field : fields) {
        line += '\t';
        for (const char letter : field) line += letter == '\t' || letter == '\n' ? ' ' : letter;
    }
    line += '\n';
    if (::write(m_file.descriptor(), line.data(), line.size()) == static_cast<ssize_t>(line.size())) return;
    std::perror("journal");
    std::_Exit(2);
}

void JournalWriter::fail(const std::string& fault) {
    note("fault", {fault});
    std::_Exit(kFaultExit);
}

Journal readJournal(const std::filesystem::path& path) {
    Journal journal;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line) && !file.eof();) addLine(journal, fieldsOf(line));  // whole lines
    return journal;
}

}  // namespace rubble::attack
