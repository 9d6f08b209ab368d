#include "editor/background/ProblemWatch.h"

#include "core/play/scene/SupportProblems.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rubble {

namespace {

constexpr int kProblemDelayMilliseconds = 120;  // a dragged seed bakes many times a second

/// Returns the problems of each bake, or of its outline if there is none.
std::vector<std::vector<Diagnostic>> search(const std::vector<std::shared_ptr<const BakedAsset>>& baked,
                                            const TaskContext& task) {
    std::vector<std::vector<Diagnostic>> problems;
    for (const std::shared_ptr<const BakedAsset>& bakedAsset : baked) {
        if (task.isCancelled()) return {};
        problems.push_back(bakedAsset->bake ? problemsOf(*bakedAsset->asset, *bakedAsset->bake, {}, task)
                                            : outlineProblems(*bakedAsset->asset));
    }
    return problems;
}

}  // namespace

ProblemWatch::ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(kProblemDelayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &ProblemWatch::check);
    connect(&m_job, &BackgroundJob::failed, this, &ProblemWatch::statusMessage);
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        m_stale.insert(asset);
        m_job.cancel();
        m_delay.start();
    });
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        // An asset may be gone, its derived threshold have changed, or what holds its instances.
        for (const Part part : {Part::Asset, Part::Material, Part::Instance, Part::Mortar, Part::Scene})
            if (changes.touches(part)) m_delay.start();
    });
}

void ProblemWatch::check() {
    Baked baked;
    for (const Id asset : m_stale) {
        if (auto found = m_bakes.find(asset); found && found->asset) baked.push_back(std::move(found));
    }
    const Project& project = m_document.project();
    // Bakes that are not finished call it again.
    const bool hasScene = mayHaveSceneProblems(project) && m_bakes.areCurrent(project);
    m_job.start(
        [baked, project = hasScene ? project : Project(),
         bakes = hasScene ? m_bakes.assetBakes() : AssetBakes()](const TaskContext& task) {
            return Found{search(baked, task), sceneProblems(project, bakes, task)};
        },
        [this, baked](Found found) { apply(baked, std::move(found)); });
}

void ProblemWatch::apply(const Baked& baked, Found all) {
    m_stale.clear();
    for (std::size_t k = 0; k < baked.size(); ++k) {
        m_results[baked[k]->asset->id] = {baked[k]->bake, std::move(all.ofBakes[k]), {}};
    }
    const Project& project = m_document.project();
    std::erase_if(m_results, [&](const auto& found) { return !findAsset(project, found.first); });
    for (auto& [id, found] : m_results) {
        const Asset& asset = *findAsset(project, id);
        found.problems = found.ofBake;
        std::ranges::move(strengthProblems(asset, *findMaterial(project, asset.material)),
                          std::back_inserter(found.problems));
        std::ranges::copy_if(all.ofScene, std::back_inserter(found.problems),
                             [&](const Diagnostic& problem) { return problem.place.asset == id; });
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

#include "moc_ProblemWatch.cpp"
