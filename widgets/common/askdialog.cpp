// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/askdialog.h"

#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QWindow>
#include <algorithm>
#include <iterator>
#include <vector>

#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"

namespace nmc {

namespace {
constexpr int kQuestionWidth = 30;  ///< line heights

/// All that exist. They are needed for each status that is shown, and to find them among the widgets of 32
/// modules' pages would take 0.3 ms.
std::vector<AskDialog*>& dialogs() {
    static std::vector<AskDialog*> all;
    return all;
}

/// Those that are open and belong to this window or widget.
std::vector<AskDialog*> openIn(const QWidget& window) {
    std::vector<AskDialog*> open;
    std::ranges::copy_if(dialogs(), std::back_inserter(open), [&window](const AskDialog* dialog) {
        const QObject* owner = dialog;
        while (owner != nullptr && owner != &window)
            owner = owner->parent();
        return owner != nullptr && dialog->isVisible();
    });
    return open;
}
}  // namespace

AskDialog& AskDialog::ask(const Question& question, std::initializer_list<Choice> choices, QWidget* owner,
                          QWidget* parent) {
    if (parent == nullptr)
        parent = owner->window();
    delete parent->findChild<AskDialog*>(question.name);
    auto* dialog = new AskDialog(question, choices, owner, parent);
    dialog->show();
    dialog->comeForward();
    return *dialog;
}

void AskDialog::comeForward() {
    raise();
    activateWindow();
}

AskDialog* AskDialog::waiting(const QWidget& window) {
    const QWindow* active = QGuiApplication::focusWindow();
    for (AskDialog* dialog : openIn(window))
        if (active != nullptr && active != dialog->windowHandle())
            return dialog;
    return nullptr;
}

void AskDialog::reviewAll(const QWidget& window) {
    for (AskDialog* dialog : openIn(window))
        dialog->review();
}

AskDialog::AskDialog(const Question& question, std::initializer_list<Choice> choices, QWidget* owner,
                     QWidget* parent)
    : QDialog(parent),
      m_owner(owner),
      m_text(question.text),
      m_label(form::newHeading({}, this)),
      m_buttons(form::newLine(this, {nullptr}, form::kUsual)) {
    dialogs().push_back(this);
    look::name(this, question.name, question.title);
    setWindowTitle(question.title);
    setAttribute(Qt::WA_DeleteOnClose);
    // An answered dialog still exists for a moment, but must not be found by its name any more.
    connect(this, &QDialog::finished, this, [this] { setObjectName({}); });
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    m_label->setObjectName(question.textName);
    m_label->setWordWrap(true);
    m_label->setMinimumWidth(fontMetrics().height() * kQuestionWidth);
    for (const Choice& choice : choices)
        addChoice(choice);
    auto* stay = form::newPush({question.stayName, question.stay}, this);
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);
    m_buttons->addWidget(stay);
    (question.goIsDefault ? qobject_cast<QPushButton*>(m_buttons->itemAt(1)->widget()) : stay)
        ->setDefault(true);

    form::fill(this, form::newColumn(this, {form::newLine(this, {glyph, {m_label, 1}}), m_buttons}, 2), 2);
    review();
}

AskDialog::~AskDialog() {
    std::erase(dialogs(), this);
}

void AskDialog::addChoice(const Choice& choice) {
    auto* button = form::newPush({choice.name, choice.text}, this);
    connect(button, &QPushButton::clicked, this, [this, go = choice.go] {
        if (!review())
            return;
        accept();
        go();
    });
    m_buttons->addWidget(button);
}

bool AskDialog::review() {
    const QString text = this->text();
    if (text.isEmpty()) {
        reject();
        return false;
    }
    look::setText(m_label, text);
    setAccessibleDescription(text);
    return true;
}

}  // namespace nmc
