#pragma once

#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

namespace rubble {

class MortarSection;
class MortarWatch;
class Selection;

/// The inspector's page for the scene: ground, gravity, damage rule, mortar and events.
class ScenePage : public QWidget {
    Q_OBJECT
public:
    ScenePage(Document& document, Selection& selection, const MortarWatch& joints, QWidget* parent = nullptr);
    void refresh();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    void buildGround(Section& section);
    void buildGravity(Section& section);
    void buildDamage(Section& section);
    void buildEvents(Section& section);

    Document& m_document;
    Form<SceneSettings> m_form;
    MortarSection* m_mortar;
    NumberField* m_height = nullptr;
    std::vector<QWidget*> m_groundControls;
    QWidget* m_rule = nullptr;
    QWidget* m_thesisThreshold = nullptr;
};

}  // namespace rubble
