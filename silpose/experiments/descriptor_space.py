def descriptor_space(rooms, run):
    pass
