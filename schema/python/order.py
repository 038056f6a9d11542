    @classmethod
    def move(cls, target: Vec2, facing: float | None = None) -> Order:
        """Goes to `target` [m] in formation and faces `facing` [rad]; None for the heading of the last stretch."""
        return cls(kind=OrderKind.MOVE, target=target, facing=facing)

    @classmethod
    def move_to_line(cls, left: Vec2, right: Vec2) -> Order:
        """Takes up a front from `left` to `right` [m]: its middle, width and facing."""
        return _core.move_to_line(left, right)

    @classmethod
    def go(cls, target: Vec2, facing: float | None = None) -> Order:
        """Goes to `target` [m], each by the shortest way."""
        return cls(kind=OrderKind.MOVE, target=target, facing=facing, manner=Manner.FREE)

    @classmethod
    def face(cls, facing: float) -> Order:
        """Turns to a heading [rad]."""
        return cls(kind=OrderKind.FACE, facing=facing)

    @classmethod
    def follow(cls, group: int, offset: Vec2) -> Order:
        """Follows a group; `offset` is from its centre, in its axes [m]."""
        return cls(kind=OrderKind.FOLLOW, group=group, offset=offset)

    @classmethod
    def follow_character(cls, character: int, offset: Vec2) -> Order:
        """Follows the character of an id; `offset` is in its axes [m]."""
        return cls(kind=OrderKind.FOLLOW, character=character, offset=offset)

    @classmethod
    def guard(cls, centre: Vec2, half_size: Vec2, facing: float) -> Order:
        """Stands round a rectangle of that centre and half size [m]."""
        return cls(kind=OrderKind.GUARD, target=centre, half_size=half_size, facing=facing)

    @classmethod
    def leave(cls, exits: list[int] | None = None) -> Order:
        """Leaves by exits: by the quickest of the ids given, of all where none are."""
        return cls(kind=OrderKind.LEAVE, exits=list(exits or []))

    @classmethod
    def wait(cls, area: int, seconds: float = 0.0) -> Order:
        """Waits in the area of an id for some seconds; 0 for no end."""
        return cls(kind=OrderKind.WAIT, area=area, seconds=seconds)

    @classmethod
    def walk(cls, facing: float) -> Order:
        """Walks on towards a heading [rad]."""
        return cls(kind=OrderKind.WALK, facing=facing)
