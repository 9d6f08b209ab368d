#include "bench/RatioReporter.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <ostream>

namespace rubble::bench {

namespace {

constexpr double kMillisecondsPerSecond = 1e3;

/// Real time where threads were used, else the time that the processor spent on it.
double millisecondsOf(const benchmark::BenchmarkReporter::Run& run) {
    const bool isReal = !run.run_name.time_type.empty();
    const double seconds = isReal ? run.real_accumulated_time : run.cpu_accumulated_time;
    return kMillisecondsPerSecond * seconds / static_cast<double>(run.iterations);
}

std::string cell(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return value > 0.0 ? text : "–";
}

void printRow(std::ostream& out, const std::vector<std::string>& cells) {
    for (const std::string& text : cells) out << "| " << text << ' ';
    out << "|\n";
}

}  // namespace

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
    std::vector<Run> single;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(single),
                 [](const Run& run) { return run.run_type == Run::RT_Iteration; });
    ConsoleReporter::ReportRuns(single);
    for (const Run& run : single) {
        double& best = m_milliseconds[std::stol(run.run_name.args)][run.run_name.function_name];
        const double time = millisecondsOf(run);
        best = best == 0.0 ? time : std::min(best, time);
    }
}

double RatioReporter::milliseconds(long argument, const std::string& name) const {
    const auto row = m_milliseconds.find(argument);
    if (row == m_milliseconds.end()) return 0.0;
    const auto time = row->second.find(name);
    return time == row->second.end() ? 0.0 : time->second;
}

void RatioReporter::Finalize() {
    std::vector<std::string> titles{m_argument};
    for (const std::string& name : m_names) titles.push_back(name + ", ms");
    for (const Ratio& ratio : m_ratios) titles.push_back(ratio.slower + " : " + ratio.faster);
    std::ostream& out = GetOutputStream();
    out << '\n';
    printRow(out, titles);
    printRow(out, {titles.size(), "---"});
    for (const auto& [argument, times] : m_milliseconds) {
        std::vector<std::string> cells{std::to_string(argument)};
        for (const std::string& name : m_names) cells.push_back(cell("%.4g", milliseconds(argument, name)));
        for (const Ratio& ratio : m_ratios) {
            const double faster = milliseconds(argument, ratio.faster);
            cells.push_back(cell("%.2f", faster > 0.0 ? milliseconds(argument, ratio.slower) / faster : 0.0));
        }
        printRow(out, cells);
    }
    out << std::flush;
}

int runBenchmarks(int argc, char** argv, RatioReporter& reporter) {
    std::string shuffled = "--benchmark_enable_random_interleaving=true", repetitions = "--benchmark_repetitions=5",
                shortly = "--benchmark_min_time=0.2";
    std::vector<char*> arguments{argv[0], shuffled.data(), repetitions.data(), shortly.data()};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return 0;
}

}  // namespace rubble::bench
