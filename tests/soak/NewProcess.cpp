#include "tests/soak/NewProcess.h"

#include "core/io/play/StateFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/ChildProcess.h"
#include "core/io/system/Temporary.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace rubble::soak {
namespace {

constexpr double kSecondsToPlayOn = 300.0;
constexpr int kFailed = 3;  // exit code

std::filesystem::path stateBeside(std::filesystem::path soakFile) { return soakFile.replace_extension(".state"); }

/// Parses lines of "STATE EVENTS".
std::vector<Trace> tracesOf(const std::string& text) {
    std::vector<Trace> traces;
    std::istringstream lines(text);
    std::string state;
    for (Trace trace; lines >> state >> trace.events;) {
        trace.state = parseContentHash(state).value_or(ContentHash{});
        traces.push_back(trace);
    }
    return traces;
}

int fail(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return kFailed;
}

int playedOn(const SoakCase& one, Session session) {
    auto next = one.inputs.begin();
    for (std::uint64_t step = 0; step < one.steps; ++step) {
        for (; next != one.inputs.end() && next->step == session.stepsDone(); ++next)  // its body is there only now
            if (const Status added = session.add(*next); !added) return fail(added.error());
        session.step();
        const Trace trace = traceOf(session);
        std::printf("%s %llu\n", trace.state.hex().c_str(), static_cast<unsigned long long>(trace.events));
    }
    return EXIT_SUCCESS;
}

}  // namespace

Trace traceOf(const Session& session) { return {session.hash(), session.events().report.hash()}; }

Result<std::vector<Trace>> tracesOfNewProcess(const SoakCase& one, const std::string& state, int threads) {
    const auto folder = TemporaryFolder::create(std::filesystem::temp_directory_path());
    if (!folder) return folder.error();
    const std::filesystem::path file = (*folder)->path() / "case.soak";
    if (const Status status = saveCase(file, one, "saved"); !status) return status.error();
    if (const Status status = writeFileAtomically(stateBeside(file), state); !status) return status.error();
    const ChildLimits limits{.memory = ChildLimits::kUnlimited, .seconds = kSecondsToPlayOn};
    const std::vector<std::string> arguments{kPlayOnOption, file.string(), kThreadsOption, std::to_string(threads)};
    const Result<ChildResult> child = runChild("/proc/self/exe", arguments, limits, {});
    if (!child) return child.error();
    if (child->exit == ChildExit::Exited && child->exitCode == EXIT_SUCCESS) return tracesOf(child->output);
    return Error{ErrorCode::BadInput, "the process that loads it fails: " + child->error};
}

int playOn(const std::filesystem::path& soakFile, int threads) {
    const Result<SoakCase> one = loadCase(soakFile);
    if (!one) return fail(one.error());
    Result<std::shared_ptr<const PlayScene>> scene = playScene(one->project);
    if (!scene) return fail(scene.error());
    SessionSettings settings;
    settings.threads = threads;
    settings.lanes = SimdWidth::Four;
    Result<Session> session = loadState(stateBeside(soakFile), *scene, settings);
    if (!session) return fail(session.error());
    return playedOn(*one, std::move(*session));
}

}  // namespace rubble::soak
