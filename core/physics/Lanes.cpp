#include "core/physics/Lanes.h"

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

std::vector<LaneWidth> availableLanes() {
    std::vector<LaneWidth> widths{LaneWidth::Scalar, LaneWidth::Four};
    if (hasEightLanes()) widths.push_back(LaneWidth::Eight);
    return widths;
}

LaneWidth widestLanes() {
    static const LaneWidth widest = availableLanes().back();
    return widest;
}

std::string_view nameOf(LaneWidth width) {
    switch (width) {
        case LaneWidth::Scalar: return "scalar";
        case LaneWidth::Four: return "four lanes";
        case LaneWidth::Eight: return "eight lanes";
    }
    return "";
}

}  // namespace rubble
