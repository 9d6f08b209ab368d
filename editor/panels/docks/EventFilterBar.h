#pragma once

#include "core/asset/project/Project.h"
#include "editor/play/EventFilter.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLineEdit;
class QToolButton;

namespace rubble {

class ElidedLabel;
class NumberField;

/// The fields of a filter of events: a toggle for each kind, text, least energy and material. A narrow bar has two
/// rows.
class EventFilterBar : public QWidget {
    Q_OBJECT
public:
    explicit EventFilterBar(QWidget* parent = nullptr);

    const EventFilter& filter() const { return m_filter; }
    void setFilter(const EventFilter& filter);
    /// Sets the materials to select from. A selected one that is gone is deselected.
    void setMaterials(const std::vector<Material>& materials);

signals:
    void filterChanged(const rubble::EventFilter& filter);
    void refused(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeKinds();
    QToolButton* makeKind(EventKind kind);
    void makeFields();
    void arrange(bool isNarrow);
    void change(const EventFilter& filter);

    EventFilter m_filter;
    std::array<QToolButton*, kEventKinds> m_toggles{};  // by kind
    QWidget* m_kinds;                                   // with the toggles
    QLineEdit* m_text;
    ElidedLabel* m_energyLabel;  // where there is room
    NumberField* m_energy;
    QComboBox* m_material;
    QToolButton* m_reset;
    QHBoxLayout* m_first;
    QHBoxLayout* m_second;  // empty if the bar is wide
    bool m_isNarrow = false;
};

}  // namespace rubble
