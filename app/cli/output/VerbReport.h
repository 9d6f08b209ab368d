#pragma once

#include "app/cli/console/CliContext.h"
#include "core/base/Diagnostic.h"
#include "core/base/Result.h"

#include <functional>
#include <string>
#include <vector>

namespace rubble {

class JsonWriter;

/// What a finding is about. Members that do not apply are empty.
struct FindingPlace {
    std::string file;         // a project, a pack or a mesh
    std::string asset;        // its name
    std::string test;         // its name
    DiagnosticPlace details;  // in the asset; the id of the asset is not used
};

/// A fault, a warning or a note.
struct Finding {
    Severity severity = Severity::Warning;
    std::string code;  // a word: "Sliver"
    FindingPlace place;
    std::string message;  // one sentence
};

/// What a verb that ran found, and its results as JSON.
struct VerbReport {
    /// What the verb looks for and found: faults, differences, failed tests. One or more lines without a line feed at
    /// the end, for standard error. If it is not empty, the program exits with kExitFindings.
    std::string conclusion;

    bool isQuiet = false;             // only results and errors are printed
    bool isJson = false;              // a document is printed instead of text
    std::vector<Finding> findings;    // for the document: all faults, warnings and notes
    bool hasErrorInFindings = false;  // the error that the verb returns is among them
    /// Writes the members of the document that only this verb has; empty: none.
    std::function<void(JsonWriter& json)> writeResults;
};

/// Adds a line to the conclusion.
void conclude(VerbReport& report, const std::string& line);

Finding findingOf(const Diagnostic& diagnostic, const std::string& file, const std::string& asset);
/// A finding of the severity Error with the name of the error's code.
Finding findingOf(const Error& error, FindingPlace place = {});

/// Prints what a verb found in words, unless a document is printed.
///
/// Errors: those of printText().
Status printResult(std::string_view text, const VerbReport& report, const CliContext& context);

/// Prints what a verb did in words, unless a document is printed or the user wants to hear of results and errors only.
///
/// Errors: those of printText().
Status printSummary(std::string_view text, const VerbReport& report, const CliContext& context);

/// Returns the document of a verb that ended with a status: docs/formats/results.md.
std::string reportJson(const VerbReport& report, const std::string& verb, const Status& status);

}  // namespace rubble
