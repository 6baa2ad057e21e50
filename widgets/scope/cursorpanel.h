// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QToolButton;

namespace nmc {

class CursorTable;
class History;
class ScopeStrips;

/// What the cursors read, below a line that says how far they are apart; the table folds into that line.
class CursorPanel : public QWidget {
    Q_OBJECT

public:
    explicit CursorPanel(QWidget* parent);

    void setUnfolded(bool unfolded);
    /// The strips, and not below them: as high as these.
    void setBeside(bool beside);
    /// As CursorTable's.
    bool showReadings(const ScopeStrips& strips, const History& history);

signals:
    void unfoldRequested(bool unfolded);

private:
    QToolButton* m_fold;
    CursorTable* m_table;
};

}  // namespace nmc
