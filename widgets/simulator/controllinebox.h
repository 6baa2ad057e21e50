// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace nmc {

class GlyphLabel;

/// A field to type control lines, in the language of nmcsim, and the literal answer of the simulator.
class ControlLineBox : public QWidget {
    Q_OBJECT

public:
    explicit ControlLineBox(QWidget* parent = nullptr);

    /// Shows the answer to any line: an error as its text, anything else as `json`, with line breaks added
    /// between its members.
    void showAnswer(const QString& line, const QByteArray& json);
    void forget();

signals:
    void lineEntered(const QString& line);

private:
    QLineEdit* m_edit;
    GlyphLabel* m_sign;
    QLabel* m_head;
    QPlainTextEdit* m_answer;
};

}  // namespace nmc
