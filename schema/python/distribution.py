    @classmethod
    def constant(cls, value: float) -> Distribution:
        """Everybody has `value`."""
        return cls(spread=Spread.CONSTANT, a=value)

    @classmethod
    def uniform(cls, low: float, high: float) -> Distribution:
        """Evenly from `low` to `high`."""
        return cls(spread=Spread.UNIFORM, a=low, b=high)

    @classmethod
    def normal(cls, mean: float, deviation: float, least: float, most: float) -> Distribution:
        """A normal distribution, cut off below `least` and above `most`."""
        return cls(spread=Spread.NORMAL, a=mean, b=deviation, least=least, most=most)

    def quantile(self, share: float) -> float:
        """The value below which a share of persons lie, in (0, 1)."""
        return _core.quantile(self, share)
