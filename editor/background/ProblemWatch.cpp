#include "editor/background/ProblemWatch.h"

#include <QThread>

#include <algorithm>
#include <iterator>

namespace rubble {

namespace {

constexpr int kDelayMilliseconds = 120;  // a dragged seed bakes many times a second

}  // namespace

ProblemWatch::ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &ProblemWatch::check);
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        m_stale.insert(asset);
        m_delay.start();
    });
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        // An asset may be gone, or its derived threshold have changed.
        if (changes.touches(Part::Asset) || changes.touches(Part::Material)) m_delay.start();
    });
}

void ProblemWatch::check() {
    TaskContext task;
    task.threads = std::max(1, QThread::idealThreadCount());
    for (const Id asset : m_stale) {
        const auto baked = m_bakes.find(asset);
        if (!baked || !baked->asset) continue;
        Entry& found = m_results[asset];
        found.bake = baked->bake;
        found.ofBake = baked->bake ? problemsOf(*baked->asset, *baked->bake, {}, task) : outlineProblems(*baked->asset);
    }
    m_stale.clear();
    const Project& project = m_document.project();
    std::erase_if(m_results, [&](const auto& found) { return !findAsset(project, found.first); });
    for (auto& [id, found] : m_results) {
        const Asset& asset = *findAsset(project, id);
        found.problems = found.ofBake;
        std::ranges::move(strengthProblems(asset, *findMaterial(project, asset.material)),
                          std::back_inserter(found.problems));
    }
    emit changed();
}

const std::vector<Diagnostic>& ProblemWatch::of(Id asset) const {
    static const std::vector<Diagnostic> kNoProblems;
    const auto found = m_results.find(asset);
    return found == m_results.end() ? kNoProblems : found->second.problems;
}

std::vector<Diagnostic> ProblemWatch::all() const {
    std::vector<Diagnostic> all;
    for (const Asset& asset : m_document.project().assets) {
        const std::vector<Diagnostic>& own = of(asset.id);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::shared_ptr<const Bake> ProblemWatch::bakeOf(Id asset) const {
    const auto found = m_results.find(asset);
    return found == m_results.end() ? nullptr : found->second.bake;
}

}  // namespace rubble
