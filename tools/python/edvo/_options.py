"""Attributes of classes of options, whose values have dotted keys: options.align.max_iterations."""


class Group:
    """The options whose keys begin with a prefix, as attributes."""

    __slots__ = ("_options", "_prefix")

    def __init__(self, options, prefix):
        object.__setattr__(self, "_options", options)
        object.__setattr__(self, "_prefix", prefix)

    def __getattr__(self, name):
        return _value(self._options, self._prefix + name)

    def __setattr__(self, name, value):
        _assign(self._options, self._prefix + name, value)

    def __dir__(self):
        return _names(self._options, self._prefix)

    def __repr__(self):
        values = self._options.to_dict()
        inside = {key: value for key, value in values.items() if key.startswith(self._prefix)}
        return f"<options {inside}>"


def _names(options, prefix=""):
    keys = (key[len(prefix):] for key in options.keys() if key.startswith(prefix))
    return sorted({key.partition(".")[0] for key in keys})


def _value(options, key):
    keys = options.keys()
    if key in keys:
        return options.get(key)
    if any(known.startswith(key + ".") for known in keys):
        return Group(options, key + ".")
    raise AttributeError(f"{type(options).__name__} has no option {key}")


def _assign(options, key, value):
    if isinstance(value, dict):
        options.update({key: value})
    elif key in options.keys():
        options.set(key, value)
    else:
        raise AttributeError(f"{type(options).__name__} has no option {key}")


def add_attributes(options_class):
    """Give a class of options attributes, keywords of its constructor, from_toml and from_dict."""
    construct = options_class.__init__

    def __init__(self, *arguments, **values):
        construct(self, *arguments)
        self.update(values)

    def from_toml(cls, path, *arguments):
        """Return options with the values that a TOML file names."""
        options = cls(*arguments)
        options.update_from_toml(str(path))
        return options

    def from_dict(cls, values, *arguments):
        """Return options with the values of a dict: dotted keys, or dicts in it."""
        options = cls(*arguments)
        options.update(values)
        return options

    def __repr__(self):
        return f"<edvo.{options_class.__name__} {self.to_dict()}>"

    def __eq__(self, other):
        return isinstance(other, options_class) and self.to_dict() == other.to_dict()

    options_class.__init__ = __init__
    options_class.__getattr__ = _value
    options_class.__setattr__ = _assign
    options_class.__dir__ = lambda self: sorted({*object.__dir__(self), *_names(self)})
    options_class.__repr__ = __repr__
    options_class.__eq__ = __eq__
    options_class.__hash__ = None
    options_class.from_toml = classmethod(from_toml)
    options_class.from_dict = classmethod(from_dict)
