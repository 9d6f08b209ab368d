#include "editor/StartPage.h"

#include "editor/Program.h"
#include "editor/RecentFiles.h"
#include "editor/icons/Icon.h"

#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

/// The examples' pictures lie in a static library: they are not there before this was called.
static void initPictures() { Q_INIT_RESOURCE(examples); }

namespace rubble {

namespace {

constexpr QSize kPicture{220, 150};  // of an example's card
constexpr int kMostRecent = 6;
constexpr int kWidth = 760;

QLabel* heading(const QString& text, double scale) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(true);
    label->setFont(font);
    return label;
}

/// "wall-with-openings.rubble": "Wall with openings".
QString titleOf(const QString& path) {
    QString title = QFileInfo(path).completeBaseName().replace('-', ' ');
    title[0] = title[0].toUpper();
    return title;
}

}  // namespace

StartPage::StartPage(RecentFiles& recent, QWidget* parent) : QWidget(parent), m_recent(recent) {
    initPictures();
    auto* columns = new QHBoxLayout;
    columns->addWidget(beginnings(), 1);
    auto* recentColumn = new QWidget;
    auto* recentLayout = new QVBoxLayout(recentColumn);
    recentLayout->setContentsMargins({});
    recentLayout->addWidget(heading(tr("Recent"), 1.15));
    m_recentRows = new QVBoxLayout;
    recentLayout->addLayout(m_recentRows);
    recentLayout->addStretch(1);
    columns->addWidget(recentColumn, 1);

    auto* page = new QWidget;
    page->setMaximumWidth(kWidth);
    auto* rows = new QVBoxLayout(page);
    rows->addWidget(heading(tr("Rubble"), 2.2));
    rows->addWidget(new QLabel(tr("Author destructible assets and see how they break.")));
    rows->addSpacing(16);
    rows->addLayout(columns);
    rows->addSpacing(16);
    if (QWidget* cards = examples()) {
        rows->addWidget(heading(tr("Examples"), 1.15));
        rows->addWidget(cards);
    }
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(page, 10);
    middle->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(1);
    layout->addLayout(middle);
    layout->addStretch(2);
    connect(&recent, &RecentFiles::changed, this, &StartPage::fillRecent);
    fillRecent();
}

QWidget* StartPage::beginnings() {
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->setContentsMargins({});
    rows->addWidget(heading(tr("Start"), 1.15));
    const auto add = [&](const char* name, const QString& text, const QString& hint, void (StartPage::*signal)()) {
        auto* button = new QCommandLinkButton(text, hint);
        button->setIcon(iconNamed(name));
        button->setToolTip(hint);
        connect(button, &QCommandLinkButton::clicked, this, signal);
        rows->addWidget(button);
    };
    add("file-new", tr("New project"), tr("Add prisms and scatter seeds over them"), &StartPage::newChosen);
    add("file-open", tr("Open a project"), tr("Go on with a .rubble file"), &StartPage::openChosen);
    add("file-import", tr("Import a mesh"), tr("OBJ, glTF, GLB, FBX, STL or PLY"), &StartPage::importChosen);
    rows->addStretch(1);
    return column;
}

/// Null where none are installed.
QWidget* StartPage::examples() {
    const QStringList paths = Program::examples();
    if (paths.isEmpty()) return nullptr;
    auto* row = new QWidget;
    auto* cards = new QHBoxLayout(row);
    cards->setContentsMargins(0, 0, 0, 0);
    for (const QString& path : paths) {
        auto* card = new QToolButton;
        card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        card->setAutoRaise(true);
        card->setText(titleOf(path));
        card->setToolTip(tr("Open a copy of this example"));
        card->setIcon(QIcon(QString(":/examples/%1.png").arg(QFileInfo(path).completeBaseName())));
        card->setIconSize(kPicture);
        connect(card, &QToolButton::clicked, this, [this, path] { emit exampleChosen(path); });
        cards->addWidget(card);
    }
    cards->addStretch(1);
    return row;
}

void StartPage::fillRecent() {
    while (QLayoutItem* item = m_recentRows->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    const QStringList paths = m_recent.paths().mid(0, kMostRecent);
    if (paths.isEmpty()) {
        auto* nothing = new QLabel(tr("Projects that you open and save will be listed here."));
        nothing->setWordWrap(true);
        nothing->setForegroundRole(QPalette::PlaceholderText);
        m_recentRows->addWidget(nothing);
    }
    for (const QString& path : paths) {
        auto* button = new QToolButton;
        button->setText(QFileInfo(path).fileName());
        button->setIcon(iconNamed("file-project"));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setToolTip(QDir::toNativeSeparators(path));
        connect(button, &QToolButton::clicked, this, [this, path] { emit recentChosen(path); });
        m_recentRows->addWidget(button);
    }
}

}  // namespace rubble
