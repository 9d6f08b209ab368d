#include "editor/panels/inspector/ScenePage.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/panels/inspector/MortarSection.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/SliderField.h"

#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr double kMaxFrictionSlider = 1.5;  // of the slider

}  // namespace

ScenePage::ScenePage(Document& document, Selection& selection, const MortarWatch& joints, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_form(
          document, [&] { return std::vector{sceneSettings(document.project())}; },
          [&](const std::vector<SceneSettings>& scenes, const QString& text, quint64 mergeKey) {
              document.push(modify(text, scenes.front(), mergeKey));
          }),
      m_mortar(new MortarSection(document, selection, joints, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* ground = new Section("ground", tr("Ground"), this);
    auto* gravity = new Section("gravity", tr("Gravity"), this);
    auto* damage = new Section("damage", tr("Damage"), this);
    auto* events = new Section("events", tr("Events"), this);
    for (Section* section : {ground, gravity, damage, static_cast<Section*>(m_mortar), events})
        layout->addWidget(section);
    layout->addStretch();
    buildGround(*ground);
    buildGravity(*gravity);
    buildDamage(*damage);
    buildEvents(*events);
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    connect(m_mortar, &MortarSection::refused, this, &ScenePage::refused);
}

void ScenePage::buildGround(Section& section) {
    auto* isOn = new QCheckBox(tr("Ground Plane"));
    isOn->setToolTip(tr("Add a horizontal plane on which bodies come to rest"));
    section.addWide(isOn);
    m_form.bind(
        isOn, tr("Enable or Disable Ground"), [](const SceneSettings& scene) { return scene.ground.isOn; },
        [](SceneSettings& scene, bool entered) { scene.ground.isOn = entered; });
    m_height = section.addRow(tr("Height"), new NumberField, tr("Height of the ground along y"));
    m_height->setRange(fieldRange(ProjectNumber::GroundHeight));
    m_form.bind(
        m_height, tr("Set Ground Height"), [](const SceneSettings& scene) { return scene.ground.height; },
        [](SceneSettings& scene, double entered) { scene.ground.height = entered; });
    auto* friction = section.addRow(tr("Friction"),
                                    new SliderField(fieldRange(ProjectNumber::Friction, 0.05), 0.0, kMaxFrictionSlider),
                                    tr("Coefficient of friction of the ground"));
    m_form.bind(
        friction, tr("Set Ground Friction"), [](const SceneSettings& scene) { return scene.ground.friction; },
        [](SceneSettings& scene, double entered) { scene.ground.friction = entered; });
    auto* restitution =
        section.addRow(tr("Restitution"), new SliderField(fieldRange(ProjectNumber::Restitution, 0.05), 0.0, 1.0),
                       tr("Coefficient of restitution of the ground"));
    m_form.bind(
        restitution, tr("Set Ground Restitution"), [](const SceneSettings& scene) { return scene.ground.restitution; },
        [](SceneSettings& scene, double entered) { scene.ground.restitution = entered; });
    m_groundControls = {m_height, friction, restitution};
}

void ScenePage::buildGravity(Section& section) {
    const QStringList axes{tr("Gravity along x"), tr("Gravity along y"), tr("Gravity along z")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = section.addRow(axes[axis], new NumberField, tr("Acceleration of gravity; y points up"));
        field->setFormat(Units::accelerations());
        field->setRange(fieldRange(ProjectNumber::Gravity));
        m_form.bind(
            field, tr("Set Gravity"), [axis](const SceneSettings& scene) { return scene.gravity[axis]; },
            [axis](SceneSettings& scene, double entered) { scene.gravity[axis] = entered; });
    }
}

void ScenePage::buildDamage(Section& section) {
    auto* rule =
        section.addRow(tr("Rule"), new QComboBox,
                       tr("What is compared with the threshold: the impulse of an impact, or the body's momentum"));
    rule->addItem(tr("Impact"), static_cast<Id>(DamageRule::Impact));
    rule->addItem(tr("Momentum"), static_cast<Id>(DamageRule::Momentum));
    m_form.bind(
        rule, tr("Set Damage Rule"), [](const SceneSettings& scene) { return static_cast<Id>(scene.damage.rule); },
        [](SceneSettings& scene, Id entered) { scene.damage.rule = static_cast<DamageRule>(entered); });
    m_rule = rule;
    auto* isThesis = new QCheckBox(tr("Simplified method of the thesis"));
    isThesis->setToolTip(
        tr("<p>Simulate with the method of the bachelor thesis that Rubble is based on, for comparison:</p>"
           "<ul><li>one threshold for all bodies instead of those of assets and instances</li>"
           "<li>the damage to a body is its momentum, m·|v|·(1 − e), not the impulse of the impact</li>"
           "<li>every fragment has a mass of 100 kg</li>"
           "<li>all fragments start with the velocity of the body's centre, without its rotation</li>"
           "<li>breaking a body does not slow the body that hits it</li></ul>"));
    isThesis->setStatusTip(tr("Simulate with the method of the bachelor thesis, for comparison"));
    section.addWide(isThesis);
    section.addNote(tr("For comparison with the work that Rubble is based on: one threshold, equal masses."));
    m_form.bind(
        isThesis, tr("Enable or Disable Simplified Method"),
        [](const SceneSettings& scene) { return scene.damage.isThesis; },
        [](SceneSettings& scene, bool entered) { scene.damage.isThesis = entered; });
    auto* threshold =
        section.addRow(tr("Threshold"), thresholdField(), tr("Threshold of all bodies with the simplified method"));
    m_form.bind(
        threshold, tr("Set Common Threshold"), [](const SceneSettings& scene) { return scene.damage.thesisThreshold; },
        [](SceneSettings& scene, double entered) { scene.damage.thesisThreshold = entered; });
    m_thesisThreshold = threshold;
}

void ScenePage::buildEvents(Section& section) {
    auto* energy = section.addRow(tr("Least energy"), new NumberField,
                                  tr("Impacts that take less energy are only counted and summed"));
    energy->setFormat(Units::energies());
    energy->setRange(fieldRange(ProjectNumber::EventEnergy));
    m_form.bind(
        energy, tr("Set Least Energy of Events"), [](const SceneSettings& scene) { return scene.events.leastEnergy; },
        [](SceneSettings& scene, double entered) { scene.events.leastEnergy = entered; });
    auto* most = section.addRow(tr("Events per step"), new NumberField,
                                tr("Report the strongest events of a step one by one, count and sum the rest"));
    most->setRange(wholeFieldRange(ProjectNumber::EventRecords));
    m_form.bind(
        most, tr("Set Events per Step"),
        [](const SceneSettings& scene) { return static_cast<double>(scene.events.maxRecords); },
        [](SceneSettings& scene, double entered) { scene.events.maxRecords = static_cast<std::uint32_t>(entered); });
}

void ScenePage::setUnits(const Units& units) {
    m_height->setFormat(units.lengths());
    m_mortar->setUnits(units);
}

void ScenePage::refresh() {
    m_form.refresh();
    m_mortar->refresh();
    const Project& project = m_document.project();
    for (QWidget* control : m_groundControls) control->setEnabled(project.ground.isOn);
    m_rule->setEnabled(!project.damage.isThesis);
    m_thesisThreshold->setEnabled(project.damage.isThesis);
}

}  // namespace rubble

#include "moc_ScenePage.cpp"
