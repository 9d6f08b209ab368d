#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/Form.h"
#include "editor/panels/Section.h"

#include <array>

class QPushButton;

namespace rubble {

/// The inspector's page for the chosen instances; what they do not have in common is shown as such.
class InstancePage : public QWidget {
    Q_OBJECT
public:
    InstancePage(Document& document, Selection& selection, QWidget* parent = nullptr);
    void refresh();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    std::vector<Instance> chosen() const;
    void buildInstance(Section& section);
    void buildPlace(Section& section);
    void buildStrength(Section& section);
    void addSwitch(Section& section, const QString& label, const QString& hint, const QString& step,
                   bool Instance::*member);
    Vec3 degreesOf(const Instance& instance) const;
    void turn(Instance& instance, int axis, double degrees);

    Document& m_document;
    Selection& m_selection;
    Form<Instance> m_form;
    Section* m_instance;
    QLineEdit* m_name = nullptr;
    QComboBox* m_asset = nullptr;
    QPushButton* m_editAsset = nullptr;
    std::array<NumberField*, 3> m_position{};
    SliderField* m_threshold = nullptr;
    Quat m_turned{1.0, 0.0, 0.0, 0.0};  // what was typed last, and what came of it: angles stay as they were typed
    Vec3 m_typedDegrees{0.0, 0.0, 0.0};
};

}  // namespace rubble
