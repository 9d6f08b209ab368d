#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

class QLabel;

namespace rubble {

/// A selected fragment that breaks further, and its thresholds.
struct BreakingFragment {
    FragmentPath path;
    std::optional<double> threshold;  // N·s, its own; none: the automatic one
    double automatic = 0.0;           // N·s, that of its level, or the one that follows from its volume
};

/// The thresholds of the selected fragments of the active asset. Hidden while none is selected.
class FragmentSection : public Section {
    Q_OBJECT
public:
    FragmentSection(Document& document, const Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    void refresh();

signals:
    void refused(const QString& sentence);

private:
    std::vector<BreakingFragment> selected() const;
    void push(const std::vector<BreakingFragment>& fragments, const QString& text, quint64 mergeKey);

    Document& m_document;
    const Selection& m_selection;
    const Bakes& m_bakes;
    Form<BreakingFragment> m_form;
    QCheckBox* m_isOwn;
    SliderField* m_threshold;
    QLabel* m_note;
};

}  // namespace rubble
