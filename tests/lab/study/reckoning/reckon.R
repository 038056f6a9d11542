# A second reckoning of the study's statistics: reads a table of trials and one of differences, prints names and values.
arguments <- commandArgs(trailingOnly = TRUE)
suppressPackageStartupMessages(library(lme4))
say <- function(name, value) cat(name, sprintf("%.12g", value), "\n")

trials <- read.csv(arguments[1])
environments <- sort(unique(trials$environment))
terms <- c()
for (e in environments) {
  trials[[paste0("e", e)]] <- as.numeric(trials$environment == e)
  trials[[paste0("t", e)]] <- as.numeric(trials$environment == e & trials$touch == 1)
  terms <- c(terms, paste0("e", e), paste0("t", e))
}
model <- as.formula(paste("y ~ 0 +", paste(c(terms, "period", "order"), collapse = " + "),
                          "+ (1 + touch | person) + (1 | layout)"))
control <- lmerControl(optimizer = "bobyqa", optCtrl = list(maxfun = 1e6, rhoend = 1e-10),
                       check.conv.singular = "ignore", check.conv.grad = "ignore", check.conv.hess = "ignore")
withTests <- requireNamespace("lmerTest", quietly = TRUE)
fitted <- if (withTests) lmerTest::lmer(model, trials, REML = TRUE, control = control) else
  lmer(model, trials, REML = TRUE, control = control)
say("criterion", REMLcrit(fitted))
say("residual", sigma(fitted))
say("person", attr(VarCorr(fitted)$person, "stddev")[1])
say("slope", attr(VarCorr(fitted)$person, "stddev")[2])
say("layout", attr(VarCorr(fitted)$layout, "stddev")[1])
table <- coef(summary(fitted))
for (e in environments) {
  row <- paste0("t", e)
  say(paste0("estimate", e), table[row, "Estimate"])
  say(paste0("error", e), table[row, "Std. Error"])
  if (withTests) say(paste0("df", e), table[row, "df"])
}

differences <- read.csv(arguments[2])
for (name in names(differences)) {
  d <- differences[[name]]
  d <- d[!is.na(d)]
  plain <- length(unique(abs(d))) == length(d) && all(d != 0)
  test <- suppressWarnings(wilcox.test(d, exact = plain && length(d) <= 50, correct = TRUE, conf.int = plain))
  say(paste0(name, ".plain"), as.numeric(plain))
  say(paste0(name, ".v"), test$statistic)
  say(paste0(name, ".p"), test$p.value)
  if (plain) {
    say(paste0(name, ".estimate"), test$estimate)
    say(paste0(name, ".low"), test$conf.int[1])
    say(paste0(name, ".high"), test$conf.int[2])
  }
  for (q in c(0.025, 0.25, 0.5, 0.9)) say(paste0(name, ".q", q), quantile(d, q, type = 7))
}
