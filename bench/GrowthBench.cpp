// Measures how the time of operations grows with the size of their input, to find those that are quadratic. Prints the
// times for each size, and the exponents between successive sizes: about 1 for O(n) and O(n log n), 2 for O(n^2).
//
//   GrowthBench [case]...    for example: GrowthBench wake
#include "bench/growth/GrowthCases.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string_view>

using namespace rubble::bench;

namespace {

struct Case {
    std::string_view name;
    double (*milliseconds)(std::size_t n);
};

constexpr std::array kCases{
    Case{"partition repair, symmetric polygon", weldingCase},
    Case{"cell in n pieces", splitCellCase},
    Case{"wake", wakeCase},
    Case{"bake of a polygon", polygonBakeCase},
    Case{"its whole mesh", wholeMeshCase},
    Case{"problems", problemsCase},
    Case{"debris", debrisCase},
    Case{"blast", blastCase},
};

constexpr std::array<std::size_t, 4> kSizes{1000, 4000, 16000, 64000};

void measure(const Case& one) {
    std::printf("| %.*s |", static_cast<int>(one.name.size()), one.name.data());
    std::array<double, kSizes.size()> times{};
    for (std::size_t k = 0; k < kSizes.size(); ++k) {
        times[k] = one.milliseconds(kSizes[k]);
        std::printf(" %.3f |", times[k]);
        std::fflush(stdout);
    }
    for (std::size_t k = 1; k < kSizes.size(); ++k) {
        const double growth = static_cast<double>(kSizes[k]) / static_cast<double>(kSizes[k - 1]);
        std::printf(" %.2f |", std::log(times[k] / times[k - 1]) / std::log(growth));
    }
    std::printf("\n");
}

bool isRequested(std::string_view name, std::span<char*> names) {
    for (const char* requested : names)
        if (name == requested) return true;
    return names.empty();
}

}  // namespace

int main(int argc, char** argv) {
    const std::span<char*> names(argv + 1, static_cast<std::size_t>(argc - 1));
    std::printf(
        "| case | 1k, ms | 4k, ms | 16k, ms | 64k, ms | exponent 1k-4k | 4k-16k | 16k-64k |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    bool isAnyKnown = false;
    for (const Case& one : kCases) {
        if (!isRequested(one.name, names)) continue;
        isAnyKnown = true;
        measure(one);
    }
    if (isAnyKnown) return 0;
    std::fprintf(stderr, "No such case.\n");
    return 2;
}
