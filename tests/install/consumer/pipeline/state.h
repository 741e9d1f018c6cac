// A header of the user's own, whose name is one of Barrido's too.
#error "a header of Barrido has included a file of the user's project"
