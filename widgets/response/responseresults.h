// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "model/response/responsefile.h"

namespace nmc {

/// The results of the runs that are drawn, A beside B, each with its uncertainty.
class ResponseResults : public QTableWidget {
    Q_OBJECT

public:
    explicit ResponseResults(QWidget* parent = nullptr);

    /// Either may be null, and is one of `runs`, which contain the moves that were made together with it.
    void showRuns(const KeptResponse* a, const KeptResponse* b, std::span<const KeptResponse> runs = {});
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

private:
    void showRun(int column, const KeptResponse* kept, std::span<const KeptResponse> runs);
};

}  // namespace nmc
