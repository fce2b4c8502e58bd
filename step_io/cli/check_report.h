#pragma once

#include "cli/command.h"
#include "cli/load.h"
#include "suture/check/certify/certify_edges.h"
#include "suture/check/continuity.h"
#include "suture/check/face_knots.h"
#include "suture/check/validity.h"
#include "suture/judge/summary.h"

namespace suture::cli {

/// All that a check has found, and of what.
struct CheckResult {
    LoadedModel model;
    Profile profile;
    ContinuityReport report;
    std::vector<KnotLine> knots;
    std::vector<EdgeCertificate> certificates;  ///< of report.edges; empty if not asked for
    double slack = 0.0;                         ///< that was asked for
    Validity validity;
    CheckSummary summary;
    double seconds = 0.0;
};

/// Exit code, verdict, tables, JSON document and the reports of `check`.
[[nodiscard]] Outcome report_check(const Command& command,
                                   const std::shared_ptr<const CheckResult>& result);

}  // namespace suture::cli
