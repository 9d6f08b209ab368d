#include "editor/dialogs/import/ImportDialog.h"

#include "core/asset/placement/InstancePlacement.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/import/ImportView.h"
#include "editor/dialogs/import/MeshReading.h"
#include "editor/dialogs/import/OfferedFallbacks.h"
#include "editor/dialogs/import/OutlinePreview.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/ScreenFit.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTableWidget>

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr QSize kImportDialogSize{920, 700};
constexpr int kRefusedLines = 5;       // shown without scrolling
constexpr int kShownRows = 8;          // of the table, without scrolling
constexpr int kMaxFragments = 10'000;  // more are set in the inspector, which says how long they take

enum AssetColumn { kName, kShape, kSize, kDepth, kAxis, kTolerance, kColumns };

QString lengthText(double metres, const Units& units) { return localizedQuantity(QuantityKind::Length, metres, units); }

QString sizeText(const PrismFit& prism, const Units& units) {
    const Vec2 size = boundsOf(prism.outline.outer).size();
    return lengthText(size.x, units) + " × " + lengthText(size.y, units);
}

QString sizeText(const SolidFit& solid, const Units& units) {
    const Vec3 size = solid.mesh->bounds.max - solid.mesh->bounds.min;
    return lengthText(size.x, units) + " × " + lengthText(size.y, units) + " × " + lengthText(size.z, units);
}

/// The cells of an asset after its name.
QStringList cellsOf(const ImportedAsset& imported, const Units& units) {
    if (imported.solid) return {ImportDialog::tr("Mesh"), sizeText(*imported.solid, units), {}, {}, {}};
    const PrismFit& prism = *imported.prism;
    return {ImportDialog::tr("Prism"), sizeText(prism, units), lengthText(prism.depth, units),
            QString::fromStdString(axisText(prism.axis)), smallLengthText(imported.tolerance, units)};
}

/// Why an asset is a prism: how far the mesh is from it.
QString deviationText(const ImportedAsset& imported, const Units& units) {
    const double deviation = imported.prism->deviation;
    if (imported.usesFallback) return {};
    if (deviation == 0.0) return ImportDialog::tr("The mesh is exactly this prism.");
    return ImportDialog::tr("The mesh deviates from this prism by up to %1.").arg(smallLengthText(deviation, units));
}

/// What an asset that is a closed mesh consists of, and why it is not a prism.
QString solidText(const SolidFit& solid, const Units& units) {
    const auto count = [](std::size_t number) { return static_cast<int>(number); };
    QStringList counts = {ImportDialog::tr("%Ln triangle(s)", nullptr, count(solid.mesh->mesh.triangles.size())),
                          localizedQuantity(QuantityKind::Volume, solid.mesh->mass.volume, units)};
    if (solid.parts > 1) counts.append(ImportDialog::tr("%Ln separate part(s)", nullptr, count(solid.parts)));
    if (solid.cavities > 0) counts.append(ImportDialog::tr("%Ln cavity(s)", nullptr, count(solid.cavities)));
    const QString text = ImportDialog::tr("It becomes a closed mesh: %1.").arg(counts.join(", "));
    if (solid.whyNoPrism.empty()) return text;
    return text + ' ' + ImportDialog::tr("It is not a prism: %1").arg(QString::fromStdString(solid.whyNoPrism));
}

/// Sets the number of seeds of a new asset's pattern.
void setSeedCount(Asset& asset, std::uint32_t count) {
    for (PatternLayer& layer : asset.pattern.layers) {
        if (auto* scatter = std::get_if<UniformScatter>(&layer.parameters)) scatter->count = count;
    }
}

/// What can be imported, before the reasons for which something cannot.
QLabel* createPossible() {
    auto* label = new QLabel(
        ImportDialog::tr("Prisms of any outline can be fractured, and closed meshes that do not cross themselves."));
    label->setWordWrap(true);
    return label;
}

/// Keeps the place of a widget free while it is hidden.
void retainSize(QWidget& widget) {
    QSizePolicy policy = widget.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget.setSizePolicy(policy);
}

QLabel* createNotes() {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

/// The result of a search.
struct ImportDialog::Found {
    std::optional<SourceModel> model;  // none if the one shown is still valid
    Result<ImportOutcome> outcome;
};

ImportDialog::ImportDialog(const QString& path, const Project& project, const Preferences& preferences, QWidget* parent)
    : QDialog(parent),
      m_path(path),
      m_units{.length = preferences.unit},
      m_project(project),
      m_view(new ImportView(preferences)) {
    setWindowTitle(tr("Import %1").arg(fileNameText(path)));
    createFields();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_import = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    auto* top = new QHBoxLayout;
    top->addWidget(m_view, 1);
    top->addWidget(createOptions());
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(createPossible());
    layout->addWidget(m_summary);
    layout->addLayout(top, 3);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_notes);
    auto* refused = new QHBoxLayout;
    refused->addWidget(m_refusedArea, 1);
    refused->addWidget(m_showProblem, 0, Qt::AlignTop);
    layout->addLayout(refused);
    layout->addWidget(m_fallbacks);
    layout->addWidget(m_progress);
    layout->addWidget(buttons);
    m_import->setDefault(true);  // after the button was added to the dialog
    resizeWithinScreen(*this, kImportDialogSize);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QComboBox* box : {m_unit, m_up}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::updateMesh);
    }
    connect(m_as, &QComboBox::currentIndexChanged, this, &ImportDialog::updateOptions);
    for (QComboBox* box : {m_as, m_axis, m_fallback}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::search);
    }
    connect(m_showProblem, &QPushButton::clicked, this, &ImportDialog::frameNextProblem);
    connect(m_mergeEqual, &QCheckBox::toggled, this, &ImportDialog::search);
    connect(&m_job, &BackgroundJob::progressed, m_progress,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&m_job, &BackgroundJob::failed, this, [this](const QString& sentence) {
        apply({{}, Error{ErrorCode::Limit, sentence.toStdString()}});
    });
    connect(this, &QDialog::finished, &m_job, &BackgroundJob::cancel);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showRow(row); });
    m_fragments->setFocus();  // a number can be typed at once, and Return imports
    m_fragments->selectAll();
}

bool ImportDialog::read(const std::filesystem::path& importer) {
    std::optional<SourceScene> scene = readMesh(m_path, importer, parentWidget());
    if (!scene) return false;
    m_scene = std::make_shared<const SourceScene>(std::move(*scene));
    showSummary();
    updateMesh();
    return true;
}

Edit ImportDialog::edit() const {
    Project imported = m_outcome->project;
    const std::vector<Id> created = assets();
    for (Asset& asset : imported.assets) {
        if (std::ranges::find(created, asset.id) != created.end())
            setSeedCount(asset, static_cast<std::uint32_t>(m_fragments->value()));
    }
    return editBetween(tr("Import %1").arg(fileNameText(m_path)), m_project, imported);
}

std::vector<Id> ImportDialog::assets() const {
    std::vector<Id> ids;
    for (const ImportedAsset& imported : m_outcome->assets) ids.push_back(imported.asset);
    return ids;
}

std::vector<Message> ImportDialog::messages() const {
    std::vector<Message> messages;
    for (const ImportedAsset& imported : m_outcome->assets) {
        for (const std::string& note : imported.notes) {
            messages.push_back({.text = QString::fromStdString(note), .asset = imported.asset});
        }
    }
    for (const RejectedObject& rejected : m_outcome->rejected) {
        messages.push_back({.severity = Severity::Error, .text = QString::fromStdString(rejected.error.message)});
    }
    return messages;
}

void ImportDialog::createFields() {
    m_summary = new QLabel;
    m_summary->setWordWrap(true);
    m_unit = createUnitBox();
    m_up = comboBox({tr("Y"), tr("Z")}, tr("Select the up axis of the file"));
    m_as = comboBox({tr("Automatic"), tr("Prism"), tr("Mesh")},
                    tr("Select what objects become; automatic: a mesh where it is not a prism"));
    m_axis = comboBox({tr("Thinnest side"), tr("X"), tr("Y (up)"), tr("Z")},
                      tr("Select the axis along which the outline is extruded"));
    m_fallback = comboBox({tr("Use mesh"), tr("Use silhouette"), tr("Use top face")},
                          tr("Select what to do with objects that are not prisms"));
    m_mergeEqual = new QCheckBox(tr("E&qual meshes are instances of one asset"));
    m_mergeEqual->setToolTip(tr("Make one asset of meshes that differ in their places only"));
    m_mergeEqual->setChecked(true);
    m_fragments = new QSpinBox;
    m_fragments->setRange(1, kMaxFragments);
    m_fragments->setValue(static_cast<int>(UniformScatter().count.amount));
    m_fragments->setToolTip(tr("Set the number of seeds of each asset, which it is fractured at"));
    m_table = new QTableWidget(0, kColumns);
    m_table->setHorizontalHeaderLabels(
        {tr("Asset"), tr("Shape"), tr("Size"), tr("Depth"), tr("Axis"), tr("Tolerance")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setAccessibleName(tr("Assets to import"));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
    m_previewTitle = new QLabel(tr("Outline, seen along the axis:"));
    m_preview = new OutlinePreview;
    retainSize(*m_previewTitle);
    retainSize(*m_preview);
    m_notes = createNotes();
    createRefused();
    m_progress = new QProgressBar;
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Examining meshes"));
    retainSize(*m_progress);  // most searches take an instant; the rest of the dialog stays in place
    m_progress->hide();
}

void ImportDialog::createRefused() {
    m_refused = createNotes();
    m_refused->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_refusedArea = new QScrollArea;
    m_refusedArea->setWidget(m_refused);
    m_refusedArea->setWidgetResizable(true);
    m_refusedArea->setFrameShape(QFrame::NoFrame);
    m_refusedArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_refusedArea->hide();
    m_showProblem = new QPushButton;
    m_showProblem->setAutoDefault(false);
    m_showProblem->hide();
    m_fallbacks = new QWidget;
    m_fallbackRow = new QHBoxLayout(m_fallbacks);
    m_fallbackRow->setContentsMargins(0, 0, 0, 0);
    m_fallbackRow->addWidget(new QLabel(tr("Import the outline instead:")));
    m_fallbackRow->addStretch();
    m_fallbacks->hide();
}

QWidget* ImportDialog::createOptions() {
    auto* options = new QWidget;
    auto* form = new QFormLayout;
    form->addRow(tr("&Unit:"), m_unit);
    form->addRow(tr("U&p axis:"), m_up);
    form->addRow(tr("Import &as:"), m_as);
    form->addRow(tr("&Extrude along:"), m_axis);
    form->addRow(tr("If &not a prism:"), m_fallback);
    form->addRow(m_mergeEqual);
    form->addRow(tr("&Fragments:"), m_fragments);
    auto* rows = new QVBoxLayout(options);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(form);
    rows->addWidget(m_previewTitle);
    rows->addWidget(m_preview, 1);
    return options;
}

ImportOptions ImportDialog::options() const {
    ImportOptions options{.metresPerUnit = metresPerUnit(*m_unit), .findsFallbacks = true};
    options.up = m_up->currentIndex() == 1 ? UpAxis::Z : UpAxis::Y;
    options.mergesEqual = m_mergeEqual->isChecked();
    options.as = static_cast<ImportShape>(m_as->currentIndex());
    options.axis = static_cast<PrismAxis>(m_axis->currentIndex());
    if (m_fallback->currentIndex() == 1) options.fallback = PrismFallback::Silhouette;
    if (m_fallback->currentIndex() == 2) options.fallback = PrismFallback::TopCap;
    return options;
}

/// Enables what applies to prisms only where there may be any.
void ImportDialog::updateOptions() {
    const ImportShape as = options().as;
    m_axis->setEnabled(as != ImportShape::Solid);
    m_fallback->setEnabled(as != ImportShape::Solid);
    m_fallback->setItemText(0, as == ImportShape::Prism ? tr("Refuse") : tr("Use mesh"));
}

/// Returns the length of one unit of the file, m.
double ImportDialog::fileUnit() const {
    const double stated = m_scene->metresPerUnit > 0.0 ? m_scene->metresPerUnit : 1.0;
    return metresPerUnit(*m_unit).value_or(stated);
}

void ImportDialog::showSummary() {
    std::size_t triangles = 0;
    for (const SourceObject& object : m_scene->objects) triangles += object.triangles.size();
    const QString unit =
        m_scene->metresPerUnit > 0.0
            ? tr("The unit of the file is %1.").arg(localizedQuantity(QuantityKind::Length, m_scene->metresPerUnit))
            : tr("The file has no unit; metres are used unless you select another unit.");
    m_summary->setText(tr("%Ln object(s)", nullptr, static_cast<int>(m_scene->objects.size())) + ", " +
                       tr("%Ln triangle(s)", nullptr, static_cast<int>(triangles)) + ". " + unit);
}

void ImportDialog::updateMesh() {
    m_isModelOutdated = true;
    search();
}

/// The previous result stays visible until the search is finished, but cannot be imported.
void ImportDialog::search() {
    m_import->setEnabled(false);
    m_fallbacks->setEnabled(false);
    m_progress->setValue(0);
    m_progress->show();
    m_job.start(
        [scene = m_scene, project = m_project, name = toPath(m_path).stem().string(), options = options(),
         unit = fileUnit(), needsModel = m_isModelOutdated](const TaskContext& task) {
            Found found{{}, importedInto(project, *scene, name, options, task)};
            if (found.outcome) moveAddedBesideOthers(project, found.outcome->project);
            if (needsModel && !task.isCancelled()) found.model = sourceModel(*scene, unit, options.up);
            return found;
        },
        [this](Found found) { apply(std::move(found)); });
}

void ImportDialog::apply(Found found) {
    m_progress->hide();
    if (found.model) {
        m_view->setModel(std::move(*found.model));
        m_isModelOutdated = false;
    }
    m_outcome.reset();
    if (found.outcome) m_outcome = std::move(*found.outcome);
    m_import->setEnabled(m_outcome && !m_outcome->assets.empty());
    QStringList refused;
    if (!found.outcome) refused.append(QString::fromStdString(found.outcome.error().message));
    if (m_outcome) {
        for (const RejectedObject& object : m_outcome->rejected)
            refused.append(QString::fromStdString(object.error.message));
    }
    showProblems();
    showRefused(refused);
    offerFallbacks();
    fillTable();
}

void ImportDialog::showRefused(const QStringList& sentences) {
    m_refused->setText(sentences.isEmpty() ? QString() : tr("Cannot be imported:") + '\n' + sentences.join('\n'));
    m_refusedArea->setVisible(!sentences.isEmpty());
    fitRefused();
}

/// Marks where refused objects cannot be cut.
void ImportDialog::showProblems() {
    std::vector<MeshProblem> problems;
    if (m_outcome) {
        for (const RejectedObject& object : m_outcome->rejected)
            if (object.problem) problems.push_back(*object.problem);
    }
    m_problemCount = problems.size();
    m_nextProblem = 0;
    m_showProblem->setText(m_problemCount > 1 ? tr("Show Next Problem") : tr("Show Problem"));
    m_showProblem->setToolTip(tr("Show in the view where a mesh cannot be cut"));
    m_showProblem->setVisible(m_problemCount > 0);
    m_view->setProblems(std::move(problems));
}

void ImportDialog::frameNextProblem() {
    m_view->frameProblem(m_nextProblem);
    m_nextProblem = (m_nextProblem + 1) % m_problemCount;
}

/// Makes the area as high as its text, up to some lines.
void ImportDialog::fitRefused() {
    if (m_refused->text().isEmpty()) return;
    const QMargins margins = layout()->contentsMargins();
    const int button = m_problemCount > 0 ? m_showProblem->sizeHint().width() + layout()->spacing() : 0;
    const int textHeight = m_refused->heightForWidth(width() - margins.left() - margins.right() - button);
    m_refusedArea->setFixedHeight(std::min(textHeight, kRefusedLines * m_refused->fontMetrics().lineSpacing()));
}

void ImportDialog::resizeEvent(QResizeEvent* event) {
    fitRefused();
    QDialog::resizeEvent(event);
}

/// Replaces the buttons by one for each fallback that imports a refused object.
void ImportDialog::offerFallbacks() {
    for (QPushButton* button : m_fallbacks->findChildren<QPushButton*>()) delete button;
    const std::vector<OfferedFallback> offered =
        m_outcome ? offeredFallbacks(m_outcome->rejected) : std::vector<OfferedFallback>();
    for (const OfferedFallback& offer : offered) {
        const WorkingFallback& fallback = offer.fallback;
        auto* button = new QPushButton(fallbackText(fallback, options().axis));
        button->setAutoDefault(false);
        button->setToolTip(fallbackToolTip(offer, m_units));
        connect(button, &QPushButton::clicked, this, [this, fallback] { use(fallback); });
        m_fallbackRow->insertWidget(m_fallbackRow->count() - 1, button);
        button->show();  // at once, not when the event loop runs again
    }
    m_fallbacks->setVisible(!offered.empty());
    m_fallbacks->setEnabled(true);
}

/// Selects the options of a fallback, which starts a search.
void ImportDialog::use(const WorkingFallback& fallback) {
    m_axis->setCurrentIndex(static_cast<int>(fallback.axis));
    m_fallback->setCurrentIndex(1 + static_cast<int>(fallback.fallback));
}

void ImportDialog::fillTable() {
    m_table->setRowCount(0);
    showOutline(nullptr);
    m_view->setAsset(nullptr);
    m_notes->clear();
    m_notes->hide();
    if (!m_outcome) return;
    m_table->setRowCount(static_cast<int>(m_outcome->assets.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ImportedAsset& imported = m_outcome->assets[static_cast<std::size_t>(row)];
        const QStringList cells =
            QStringList(nameText(findAsset(m_outcome->project, imported.asset)->name)) + cellsOf(imported, m_units);
        for (int column = 0; column < kColumns; ++column) {
            m_table->setItem(row, column, new QTableWidgetItem(cells[column]));
        }
    }
    fitTable();
    m_table->setCurrentCell(0, kName);
}

/// Makes the table high enough for all rows, up to some.
void ImportDialog::fitTable() {
    const int rows = std::min(m_table->rowCount(), kShownRows);
    const int height = rows == 0 ? 0 : rows * m_table->rowHeight(0);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + height + 2 * m_table->frameWidth());
}

/// Shows the outline of an asset; the place is empty for a mesh, and for null.
void ImportDialog::showOutline(const ImportedAsset* imported) {
    const bool hasOutline = imported != nullptr && imported->prism;
    m_preview->setOutline(hasOutline ? imported->prism->outline : Polygon());
    m_preview->setVisible(hasOutline);
    m_previewTitle->setVisible(hasOutline);
}

void ImportDialog::showRow(int row) {
    if (!m_outcome || row < 0) return;
    const ImportedAsset& imported = m_outcome->assets[static_cast<std::size_t>(row)];
    showOutline(&imported);
    m_view->setAsset(&imported);
    QStringList notes;
    if (imported.solid) notes.append(solidText(*imported.solid, m_units));
    for (const std::string& note : imported.notes) notes.append(QString::fromStdString(note));
    const QString deviation = imported.prism ? deviationText(imported, m_units) : QString();
    if (!deviation.isEmpty()) notes.append(deviation);
    m_notes->setText(notes.join('\n'));
    m_notes->setVisible(!notes.isEmpty());
}

}  // namespace rubble

#include "moc_ImportDialog.cpp"
