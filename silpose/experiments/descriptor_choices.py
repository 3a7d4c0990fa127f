def descriptor_choices(rooms, run):
    pass
