#pragma once

#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

namespace rubble {

/// The inspector's page for the scene: ground, gravity, damage rule and events.
class ScenePage : public QWidget {
    Q_OBJECT
public:
    explicit ScenePage(Document& document, QWidget* parent = nullptr);
    void refresh();
    void setUnits(const Units& units) { m_height->setFormat(units.lengths()); }

signals:
    void refused(const QString& sentence);

private:
    void buildGround(Section& section);
    void buildGravity(Section& section);
    void buildDamage(Section& section);
    void buildEvents(Section& section);

    Document& m_document;
    Form<SceneSettings> m_form;
    NumberField* m_height = nullptr;
    std::vector<QWidget*> m_groundControls;
    QWidget* m_rule = nullptr;
    QWidget* m_thesisThreshold = nullptr;
};

}  // namespace rubble
