#include "core/play/state/PlayEvents.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

template <class Element>
void move(std::vector<Element>& from, std::vector<Element>& to) {
    std::ranges::move(from, std::back_inserter(to));
}

}  // namespace

void append(PlayEvents&& interval, PlayEvents& step) {
    auto& [inputs, breaks, splits, impacts, born, removed, taken, diagnostics, energy, happened, weakImpacts, report] =
        interval;
    move(inputs, step.inputs);
    move(breaks, step.breaks);
    move(splits, step.splits);
    move(impacts, step.impacts);
    move(born, step.born);
    move(removed, step.removed);
    move(taken, step.taken);
    move(diagnostics, step.diagnostics);
    move(energy, step.energy);
    move(happened, step.happened);
    step.weakImpacts.count += weakImpacts.count;
    step.weakImpacts.energy += weakImpacts.energy;
    move(report.records, step.report.records);
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        step.report.omitted[kind].count += report.omitted[kind].count;
        step.report.omitted[kind].energy += report.omitted[kind].energy;
    }
    step.report.restEnergy += report.restEnergy;
}

}  // namespace rubble
