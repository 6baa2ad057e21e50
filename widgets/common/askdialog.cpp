// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/askdialog.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWindow>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"

namespace nmc {

namespace {
constexpr int kQuestionWidth = 30;  ///< line heights
}

AskDialog& AskDialog::ask(const Question& question, std::initializer_list<Choice> choices, QWidget* window) {
    auto* dialog = window->findChild<AskDialog*>(question.name);
    if (dialog == nullptr) {
        dialog = new AskDialog(question, choices, window);
        dialog->show();
    }
    dialog->comeForward();
    return *dialog;
}

void AskDialog::comeForward() {
    raise();
    activateWindow();
}

AskDialog* AskDialog::waiting(const QWidget& window) {
    const QWindow* active = QGuiApplication::focusWindow();
    for (AskDialog* dialog : window.findChildren<AskDialog*>(Qt::FindDirectChildrenOnly))
        if (dialog->isVisible() && active != nullptr && active != dialog->windowHandle())
            return dialog;
    return nullptr;
}

void AskDialog::reviewAll(const QWidget& window) {
    for (AskDialog* dialog : window.findChildren<AskDialog*>(Qt::FindDirectChildrenOnly))
        if (dialog->isVisible())
            dialog->review();
}

AskDialog::AskDialog(const Question& question, std::initializer_list<Choice> choices, QWidget* window)
    : QDialog(window), m_text(question.text), m_label(new QLabel(this)), m_buttons(new QHBoxLayout) {
    look::name(this, question.name, question.title);
    setWindowTitle(question.title);
    setAttribute(Qt::WA_DeleteOnClose);
    // An answered dialog still exists for a moment, but must not be found by its name any more.
    connect(this, &QDialog::finished, this, [this] { setObjectName({}); });
    const int unit = look::gridUnit(this);
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    m_label->setObjectName(question.textName);
    m_label->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    m_label->setFont(bold);
    m_label->setWordWrap(true);
    m_label->setMinimumWidth(fontMetrics().height() * kQuestionWidth);
    m_buttons->addStretch(1);
    for (const Choice& choice : choices)
        addChoice(choice);
    auto* stay = new QPushButton(question.stay, this);
    look::name(stay, question.stayName, QString(question.stay).remove(u'&'));
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);
    m_buttons->addWidget(stay);
    (question.stayIsDefault ? stay : qobject_cast<QPushButton*>(m_buttons->itemAt(1)->widget()))
        ->setDefault(true);

    auto* message = new QHBoxLayout;
    message->setSpacing(unit);
    message->addWidget(glyph);
    message->addWidget(m_label, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->setSpacing(unit * 2);
    layout->addLayout(message);
    layout->addLayout(m_buttons);
    review();
}

void AskDialog::addChoice(const Choice& choice) {
    auto* button = new QPushButton(choice.text, this);
    look::name(button, choice.name, QString(choice.text).remove(u'&'));
    connect(button, &QPushButton::clicked, this, [this, go = choice.go] {
        if (!review())
            return;
        accept();
        go();
    });
    m_buttons->addWidget(button);
}

bool AskDialog::review() {
    const QString text = m_text();
    if (text.isEmpty()) {
        reject();
        return false;
    }
    look::setText(m_label, text);
    setAccessibleDescription(text);
    return true;
}

}  // namespace nmc
