#include "core/play/state/EventRecord.h"

#include "core/base/Hash.h"

#include <algorithm>

namespace rubble {
namespace {

void addVector(Hasher& hasher, Vec3 vector) {
    for (int axis = 0; axis < 3; ++axis) hasher.add(vector[axis]);
}

void addRecord(Hasher& hasher, const EventRecord& record) {
    for (const std::uint64_t value :
         {record.step, std::uint64_t{static_cast<std::uint8_t>(record.kind)}, std::uint64_t{record.body},
          std::uint64_t{record.other}, std::uint64_t{record.instance}, std::uint64_t{record.fragment.size()},
          std::uint64_t{record.count}, std::uint64_t{record.materials[0]}, std::uint64_t{record.materials[1]},
          std::uint64_t{static_cast<std::uint8_t>(record.reason)}}) {
        hasher.add(value);
    }
    hasher.add(std::string_view(record.fragment));
    addVector(hasher, record.point);
    addVector(hasher, record.normal);
    for (const double value : {record.impulse, record.speed, record.energy, record.area, record.mass}) {
        hasher.add(value);
    }
    addVector(hasher, record.box.min);
    addVector(hasher, record.box.max);
}

}  // namespace

std::string_view nameOf(EventKind kind) {
    constexpr std::array<std::string_view, kEventKinds> kNames{"impact", "bonds",   "detached",
                                                               "broken", "settled", "removed"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string_view nameOf(RemovalReason reason) {
    constexpr std::array<std::string_view, 5> kNames{"", "lifetime", "budget", "leftWorld", "input"};
    return kNames[static_cast<std::size_t>(reason)];
}

bool EventReport::isEmpty() const {
    return records.empty() && restEnergy == 0.0 &&
           std::ranges::all_of(omitted, [](const OmittedEvents& one) { return one.count == 0; });
}

double EventReport::energy() const {
    double sum = restEnergy;
    for (const EventRecord& record : records) sum += record.energy;
    for (const OmittedEvents& one : omitted) sum += one.energy;
    return sum;
}

std::uint64_t EventReport::hash() const {
    Hasher hasher;
    for (const EventRecord& record : records) addRecord(hasher, record);
    for (const OmittedEvents& one : omitted) {
        hasher.add(std::uint64_t{one.count});
        hasher.add(one.energy);
    }
    hasher.add(restEnergy);
    return hasher.digest().low;
}

}  // namespace rubble
