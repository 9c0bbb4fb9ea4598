document.title = "Omote stage";
