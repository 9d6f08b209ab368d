#include "editor/document/ProblemWatch.h"

#include <QThread>

#include <algorithm>
#include <iterator>

namespace rubble {

namespace {

constexpr int kRestMilliseconds = 120;  // a dragged seed bakes many times a second

}  // namespace

ProblemWatch::ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ProblemWatch::look);
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        m_stale.insert(asset);
        m_rest.start();
    });
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        // One may be gone, or its threshold be derived anew.
        if (changes.touches(Part::Asset) || changes.touches(Part::Material)) m_rest.start();
    });
}

void ProblemWatch::look() {
    TaskContext task;
    task.threads = std::max(1, QThread::idealThreadCount());
    for (const Id asset : m_stale) {
        const auto baked = m_bakes.find(asset);
        if (!baked || !baked->asset) continue;
        Found& found = m_found[asset];
        found.bake = baked->bake;
        found.ofBake = baked->bake ? problemsOf(*baked->asset, *baked->bake, {}, task) : outlineProblems(*baked->asset);
    }
    m_stale.clear();
    const Project& project = m_document.project();
    std::erase_if(m_found, [&](const auto& found) { return !findAsset(project, found.first); });
    for (auto& [id, found] : m_found) {
        const Asset& asset = *findAsset(project, id);
        found.problems = found.ofBake;
        std::ranges::move(strengthProblems(asset, *findMaterial(project, asset.material)),
                          std::back_inserter(found.problems));
    }
    emit changed();
}

const std::vector<Problem>& ProblemWatch::of(Id asset) const {
    static const std::vector<Problem> kNothing;
    const auto found = m_found.find(asset);
    return found == m_found.end() ? kNothing : found->second.problems;
}

std::vector<Problem> ProblemWatch::all() const {
    std::vector<Problem> all;
    for (const Asset& asset : m_document.project().assets) {
        const std::vector<Problem>& own = of(asset.id);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::shared_ptr<const Bake> ProblemWatch::bakeOf(Id asset) const {
    const auto found = m_found.find(asset);
    return found == m_found.end() ? nullptr : found->second.bake;
}

}  // namespace rubble
