#include "editor/background/MortarWatch.h"

#include "core/play/scene/PlayScene.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kMortarDelayMilliseconds = 150;

}  // namespace

MortarWatch::MortarWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(kMortarDelayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &MortarWatch::check);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        const bool isOfJoints = changes.touches(Part::Mortar) || changes.touches(Part::Instance) ||
                                changes.touches(Part::Asset) || changes.touches(Part::Scene);
        if (isOfJoints) invalidate();
    });
    connect(&bakes, &Bakes::changed, this, &MortarWatch::invalidate);
    invalidate();
}

const JoinedMortar* MortarWatch::find(Id mortar) const {
    const auto found = std::ranges::find(m_joined, mortar, &JoinedMortar::mortar);
    return found != m_joined.end() ? &*found : nullptr;
}

void MortarWatch::invalidate() {
    m_job.cancel();
    m_isCurrent = false;
    if (!m_document.project().mortars.empty() || !m_joined.empty()) m_delay.start();
}

/// Waits for bakes that are not finished: they call it again.
void MortarWatch::check() {
    const Project& project = m_document.project();
    if (project.mortars.empty()) return set({});
    if (!m_bakes.areCurrent(project)) return;
    m_job.start([project, bakes = m_bakes.assetBakes()](
                    const TaskContext& task) { return playScene(project, bakes, task, FindContacts::OnBreak); },
                [this](const Result<std::shared_ptr<const PlayScene>>& scene) {
                    set(scene ? (*scene)->mortars : std::vector<JoinedMortar>());
                });
}

void MortarWatch::set(std::vector<JoinedMortar> joined) {
    m_joined = std::move(joined);
    m_isCurrent = true;
    emit changed();
}

}  // namespace rubble

#include "moc_MortarWatch.cpp"
