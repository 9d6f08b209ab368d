#include "editor/panels/inspector/FragmentSection.h"

#include "core/asset/bake/FragmentSets.h"
#include "core/asset/strength/FragmentThresholds.h"
#include "core/asset/strength/Threshold.h"
#include "core/play/scene/PlayAsset.h"
#include "editor/commands/FragmentEdits.h"

#include <QLabel>

#include <algorithm>

namespace rubble {

FragmentSection::FragmentSection(Document& document, const Selection& selection, const Bakes& bakes, QWidget* parent)
    : Section("fragments", tr("Selected Fragments"), parent),
      m_document(document),
      m_selection(selection),
      m_bakes(bakes),
      m_form(
          document, [this] { return selected(); },
          [this](const std::vector<BreakingFragment>& fragments, const QString& text, quint64 mergeKey) {
              push(text, mergeKey, [&](Asset& asset) {
                  for (const BreakingFragment& each : fragments) setFragmentThreshold(asset, each.path, each.threshold);
              });
          }),
      m_bondedForm(
          document, [this] { return selectedBonded(); },
          [this](const std::vector<BondedFragment>& fragments, const QString& text, quint64 mergeKey) {
              push(text, mergeKey, [&](Asset& asset) {
                  for (const auto& [path, neverBreaks] : fragments) setNeverBreaks(asset, path, neverBreaks);
              });
          }),
      m_isOwn(new QCheckBox(tr("Override Threshold"))),
      m_threshold(thresholdField()),
      m_neverBreaks(new QCheckBox(tr("Never Breaks"))),
      m_note(new QLabel) {
    buildThreshold();
    m_note->setWordWrap(true);
    addWide(m_note);
    buildNeverBreaks();
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_bondedForm.setRefused([this](const QString& sentence) { emit refused(sentence); });
    connect(&selection, &Selection::seedsChanged, this, &FragmentSection::refresh);
    connect(&bakes, &Bakes::changed, this, &FragmentSection::refresh);
    refresh();
}

void FragmentSection::buildThreshold() {
    m_isOwn->setToolTip(tr("Override the threshold that follows from the fragment's volume or is set for its level"));
    m_isOwn->setObjectName("override-fragment-threshold");
    addWide(m_isOwn);
    m_form.bind(
        m_isOwn, tr("Override Threshold of Fragments"),
        [](const BreakingFragment& fragment) { return fragment.threshold.has_value(); },
        [](BreakingFragment& fragment, bool isOn) {
            fragment.threshold = isOn ? std::optional(fragment.threshold.value_or(fragment.automatic)) : std::nullopt;
        });
    addRow(tr("Threshold"), m_threshold, tr("Impulse at which the fragment breaks further"));
    m_threshold->setAccessibleName(tr("Threshold of fragments"));
    m_form.bind(
        m_threshold, tr("Set Threshold of Fragments"),
        [](const BreakingFragment& fragment) { return fragment.threshold.value_or(fragment.automatic); },
        [](BreakingFragment& fragment, double entered) { fragment.threshold = entered; });
}

void FragmentSection::buildNeverBreaks() {
    m_neverBreaks->setToolTip(tr("Keep the fragments from breaking, and the bonds between them"));
    m_neverBreaks->setObjectName("never-breaks");
    addWide(m_neverBreaks);
    m_bondedForm.bind(m_neverBreaks, tr("Set Whether Fragments Never Break"), &BondedFragment::neverBreaks);
}

/// Only what breaks further has a threshold.
std::vector<BreakingFragment> FragmentSection::selected() const {
    std::vector<BreakingFragment> fragments;
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    const auto baked = m_bakes.find(m_selection.asset());
    if (asset == nullptr || !baked || !baked->bake || m_selection.fragments().isEmpty()) return fragments;
    const Bake& bake = *baked->bake;
    const FragmentSet isSelected = fragmentsOf(m_selection.fragments(), bake);
    const double whole = thresholdOf(m_document.project(), *asset);
    Asset automatic = *asset;
    automatic.fragmentThresholds.clear();
    for (const BakedFracture& fracture : bake.fractures) {
        if (fracture.parent == kNone || !isSelected[fracture.parent]) continue;
        const BakedFragment fragment = bake.fragment(fracture.parent);
        const FragmentPath path = bake.fragmentPath(fracture.parent);
        const double byVolume = whole * thresholdScaleOf(fragment.solid.volume() / bake.whole.volume);
        fragments.push_back({.path = path,
                             .threshold = ownThreshold(*asset, path),
                             .automatic = fragmentThreshold(automatic, path, fragment.level).value_or(byVolume)});
    }
    return fragments;
}

std::vector<BondedFragment> FragmentSection::selectedBonded() const {
    std::vector<BondedFragment> fragments;
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    const auto baked = m_bakes.find(m_selection.asset());
    if (asset == nullptr || asset->breakAs != BreakAs::Bonded || !baked || !baked->bake) return fragments;
    const Bake& bake = *baked->bake;
    for (const std::uint32_t root : rootsOf(bake, fragmentsOf(m_selection.fragments(), bake))) {
        const FragmentPath path = bake.fragmentPath(root);
        fragments.push_back({path, std::ranges::binary_search(asset->bonding.neverBreaks, path)});
    }
    return fragments;
}

void FragmentSection::push(const QString& text, quint64 mergeKey, const std::function<void(Asset&)>& change) {
    Asset changed = *findAsset(m_document.project(), m_selection.asset());
    change(changed);
    Edit edit{.text = text, .mergeKey = mergeKey};
    const Id id = changed.id;
    edit.replacements.push_back(Replacement<Asset>{id, std::move(changed)});
    m_document.push(std::move(edit));
}

void FragmentSection::refresh() {
    setVisible(!m_selection.fragments().isEmpty());
    if (m_selection.fragments().isEmpty()) return;
    const std::vector<BreakingFragment> fragments = selected();
    const bool doBreak = !fragments.empty();
    const bool areBonded = !selectedBonded().empty();
    m_isOwn->setVisible(doBreak && !areBonded);
    setRowVisible(m_threshold, doBreak && !areBonded);
    m_note->setText(doBreak ? tr("%Ln selected fragment(s) break further.", nullptr, static_cast<int>(fragments.size()))
                            : tr("None of the selected fragments breaks further. Fracture them, or add a level."));
    m_neverBreaks->setVisible(areBonded);
    m_bondedForm.refresh();
    if (!doBreak) return;
    m_form.refresh();
    m_threshold->setEnabled(std::ranges::all_of(
        fragments, [](const BreakingFragment& fragment) { return fragment.threshold.has_value(); }));
}

}  // namespace rubble

#include "moc_FragmentSection.cpp"
