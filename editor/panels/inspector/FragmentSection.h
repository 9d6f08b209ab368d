#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

#include <functional>

class QLabel;

namespace rubble {

/// A selected fragment that breaks further, and its thresholds.
struct BreakingFragment {
    FragmentPath path;
    std::optional<double> threshold;  // N·s, its own; none: the automatic one
    double automatic = 0.0;           // N·s, that of its level, or the one that follows from its volume
};

/// A selected fragment of an asset that breaks as bonded; none of its ancestors is selected.
struct BondedFragment {
    FragmentPath path;
    bool neverBreaks = false;
};

/// The thresholds of the selected fragments of the active asset, and whether they never break. Hidden while none is
/// selected.
class FragmentSection : public Section {
    Q_OBJECT
public:
    FragmentSection(Document& document, const Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    void refresh();

signals:
    void refused(const QString& sentence);

private:
    std::vector<BreakingFragment> selected() const;
    std::vector<BondedFragment> selectedBonded() const;
    void buildThreshold();
    void buildNeverBreaks();
    void push(const QString& text, quint64 mergeKey, const std::function<void(Asset&)>& change);

    Document& m_document;
    const Selection& m_selection;
    const Bakes& m_bakes;
    Form<BreakingFragment> m_form;
    Form<BondedFragment> m_bondedForm;
    QCheckBox* m_isOwn;
    SliderField* m_threshold;
    QCheckBox* m_neverBreaks;
    QLabel* m_note;
};

}  // namespace rubble
