#include "core/physics/math/Lanes.h"

namespace rubble {
namespace {

bool hasEightLanes() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

}  // namespace

std::vector<SimdWidth> availableSimdWidths() {
    std::vector<SimdWidth> widths{SimdWidth::Scalar, SimdWidth::Four};
    if (hasEightLanes()) widths.push_back(SimdWidth::Eight);
    return widths;
}

SimdWidth widestSimd() {
    static const SimdWidth widest = availableSimdWidths().back();
    return widest;
}

std::string_view nameOf(SimdWidth width) {
    switch (width) {
        case SimdWidth::Scalar: return "scalar";
        case SimdWidth::Four: return "four lanes";
        case SimdWidth::Eight: return "eight lanes";
    }
    return "";
}

}  // namespace rubble
