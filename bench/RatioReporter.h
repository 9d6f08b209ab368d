#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace rubble::bench {

/// How many times as long `slower` takes as `faster`; both are names of benchmarks.
struct Ratio {
    std::string slower;
    std::string faster;
};

/// Prints at the end one table in Markdown: a row for each argument, a column in milliseconds for each benchmark, a
/// column for each ratio. Of all repetitions the quickest counts: what else runs on the machine only ever adds time.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    RatioReporter(std::string argument, std::vector<std::string> names, std::vector<Ratio> ratios)
        : ConsoleReporter(OO_Tabular),
          m_argument(std::move(argument)),
          m_names(std::move(names)),
          m_ratios(std::move(ratios)) {}

    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

    /// The quickest time of a benchmark on an argument, in milliseconds; 0 where it did not run.
    double milliseconds(long argument, const std::string& name) const;

private:
    std::string m_argument;
    std::vector<std::string> m_names;
    std::vector<Ratio> m_ratios;
    std::map<long, std::map<std::string, double>> m_milliseconds;  // by argument and name
};

/// Runs all registered benchmarks, repetitions shuffled, on the heap as it is by default: memory may go back to the
/// system between runs and have to be asked for again, on all sides. Options of Google Benchmark are understood. Gives
/// the program's exit code.
int runBenchmarks(int argc, char** argv, RatioReporter& reporter);

}  // namespace rubble::bench
