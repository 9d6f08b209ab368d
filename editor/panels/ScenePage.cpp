#include "editor/panels/ScenePage.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/panels/ThresholdField.h"

#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr double kMostUsualFriction = 1.5;  // the sliders' ends

}  // namespace

ScenePage::ScenePage(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_form(
          document, [&] { return std::vector{sceneSettings(document.project())}; },
          [&](const std::vector<SceneSettings>& scenes, const QString& text, quint64 stroke) {
              document.push(altered(text, scenes.front(), stroke));
          }) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* ground = new Section("ground", tr("Ground"), this);
    auto* gravity = new Section("gravity", tr("Gravity"), this);
    auto* damage = new Section("damage", tr("Damage"), this);
    for (Section* section : {ground, gravity, damage}) layout->addWidget(section);
    layout->addStretch();
    buildGround(*ground);
    buildGravity(*gravity);
    buildDamage(*damage);
}

void ScenePage::buildGround(Section& section) {
    auto* isOn = new QCheckBox(tr("There is a ground"));
    isOn->setToolTip(tr("A level plane that bodies fall on"));
    section.addWide(isOn);
    m_form.bind(
        isOn, tr("Switch ground"), [](const SceneSettings& scene) { return scene.ground.isOn; },
        [](SceneSettings& scene, bool entered) { scene.ground.isOn = entered; });
    m_height = section.addRow(tr("Height"), new NumberField, tr("Where the ground lies along y"));
    m_form.bind(
        m_height, tr("Move ground"), [](const SceneSettings& scene) { return scene.ground.height; },
        [](SceneSettings& scene, double entered) { scene.ground.height = entered; });
    auto* friction =
        section.addRow(tr("Friction"), new SliderField(FieldRange{.min = 0.0, .step = 0.05}, 0.0, kMostUsualFriction),
                       tr("Coulomb's coefficient of the ground"));
    m_form.bind(
        friction, tr("Set friction"), [](const SceneSettings& scene) { return scene.ground.friction; },
        [](SceneSettings& scene, double entered) { scene.ground.friction = entered; });
    auto* restitution = section.addRow(tr("Restitution"), new SliderField(FieldRange::zeroToOne(), 0.0, 1.0),
                                       tr("How much bodies bounce off the ground"));
    m_form.bind(
        restitution, tr("Set restitution"), [](const SceneSettings& scene) { return scene.ground.restitution; },
        [](SceneSettings& scene, double entered) { scene.ground.restitution = entered; });
    m_ofGround = {m_height, friction, restitution};
}

void ScenePage::buildGravity(Section& section) {
    const QStringList axes{tr("Along x"), tr("Along y"), tr("Along z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(axes[axis], new NumberField, tr("Acceleration along this axis; y points up"));
        field->setFormat({tr("m/s²"), 0});
        m_form.bind(
            field, tr("Set gravity"), [axis](const SceneSettings& scene) { return scene.gravity[axis]; },
            [axis](SceneSettings& scene, double entered) { scene.gravity[axis] = entered; });
    }
}

void ScenePage::buildDamage(Section& section) {
    auto* rule = section.addRow(tr("Rule"), new QComboBox,
                                tr("Impact: a body breaks by the impulse of a blow. Momentum: by its own motion"));
    rule->addItem(tr("Impact"), static_cast<Id>(DamageRule::Impact));
    rule->addItem(tr("Momentum"), static_cast<Id>(DamageRule::Momentum));
    m_form.bind(
        rule, tr("Set damage rule"), [](const SceneSettings& scene) { return static_cast<Id>(scene.damage.rule); },
        [](SceneSettings& scene, Id entered) { scene.damage.rule = static_cast<DamageRule>(entered); });
    m_rule = rule;
    auto* isThesis = new QCheckBox(tr("Compare with the thesis's method"));
    isThesis->setToolTip(
        tr("<p>Play the scene as the bachelor's thesis that Rubble grew out of does, to compare the two:</p>"
           "<ul><li>one threshold for all bodies; those of assets and instances do not count</li>"
           "<li>a body breaks by its momentum, m·|v|·(1 − e), not by the impulse of the blow</li>"
           "<li>every piece weighs 100 kg, whatever its size and material</li>"
           "<li>all pieces leave with the velocity of the whole's centre, also where it spins</li>"
           "<li>what strikes loses nothing by breaking it</li></ul>"
           "<p>For scenes of your own leave it off.</p>"));
    isThesis->setStatusTip(tr("One threshold for all, momentum rule, 100 kg a piece, breaking costs nothing"));
    section.addWide(isThesis);
    m_form.bind(
        isThesis, tr("Switch thesis preset"), [](const SceneSettings& scene) { return scene.damage.isThesis; },
        [](SceneSettings& scene, bool entered) { scene.damage.isThesis = entered; });
    auto* threshold =
        section.addRow(tr("Threshold"), thresholdField(),
                       tr("What every body withstands by the thesis's method, in place of its own threshold"));
    m_form.bind(
        threshold, tr("Set threshold"), [](const SceneSettings& scene) { return scene.damage.thesisThreshold; },
        [](SceneSettings& scene, double entered) { scene.damage.thesisThreshold = entered; });
    m_thesisThreshold = threshold;
}

void ScenePage::refresh() {
    m_form.refresh();
    const Project& project = m_document.project();
    for (QWidget* control : m_ofGround) control->setEnabled(project.ground.isOn);
    m_rule->setEnabled(!project.damage.isThesis);
    m_thesisThreshold->setEnabled(project.damage.isThesis);
}

}  // namespace rubble
